// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace sparkout {

/// What was visible before, for Back and Forward.
class PlotHistory {
public:
    /// What is visible, as numbers of the plot's own meaning (usually ranges of axes).
    using State = std::vector<double>;
    static constexpr std::size_t mostStates = 100;

    /// Forgets all, and starts from a state.
    void restart(State state);
    /// Something else became visible. Steps of one gesture (a number above 0) are one entry; a
    /// state that is visible already is none.
    void visit(State state, int gesture = 0);
    /// What is visible is replaced without a way back, as by a new result.
    void amend(State state);

    [[nodiscard]] bool canGoBack() const { return m_at > 0; }
    [[nodiscard]] bool canGoForward() const { return m_at + 1 < m_states.size(); }
    const State& back();    ///< only if canGoBack()
    const State& forward(); ///< only if canGoForward()
    [[nodiscard]] std::size_t size() const { return m_states.size(); }

private:
    std::vector<State> m_states{State{}};
    std::size_t m_at = 0; ///< index of what is visible
    int m_gesture = 0;    ///< that made the visible entry
};

} // namespace sparkout
