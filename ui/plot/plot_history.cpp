// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_history.h"

#include <utility>

namespace sparkout {

void PlotHistory::restart(State state) {
    m_states.assign(1, std::move(state));
    m_at = 0;
    m_gesture = 0;
}

void PlotHistory::visit(State state, int gesture) {
    if (state == m_states[m_at]) {
        return;
    }
    m_states.resize(m_at + 1);
    if (gesture > 0 && gesture == m_gesture) {
        m_states[m_at] = std::move(state);
        return;
    }
    m_gesture = gesture;
    m_states.push_back(std::move(state));
    if (m_states.size() > mostStates) {
        m_states.erase(m_states.begin());
    }
    m_at = m_states.size() - 1;
}

void PlotHistory::amend(State state) {
    m_states[m_at] = std::move(state);
    m_gesture = 0;
}

const PlotHistory::State& PlotHistory::back() {
    m_gesture = 0;
    return m_states[--m_at];
}

const PlotHistory::State& PlotHistory::forward() {
    m_gesture = 0;
    return m_states[++m_at];
}

} // namespace sparkout
