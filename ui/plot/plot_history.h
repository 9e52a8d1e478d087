// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace sparkout {

/// The visible states of a plot, for Back and Forward.
class PlotHistory {
public:
    /// A visible state, as numbers defined by the plot (usually ranges of axes).
    using State = std::vector<double>;
    static constexpr std::size_t mostStates = 100;

    /// Forgets all, and starts from a state.
    void restart(State state);
    /// Adds a new visible state. Steps of one gesture (a positive number) are one entry; an
    /// unchanged state is not added.
    void visit(State state, int gesture = 0);
    /// Replaces the current state without a way back, for instance by a new result.
    void amend(State state);

    [[nodiscard]] bool canGoBack() const { return m_at > 0; }
    [[nodiscard]] bool canGoForward() const { return m_at + 1 < m_states.size(); }
    const State& back();    ///< requires canGoBack()
    const State& forward(); ///< requires canGoForward()
    [[nodiscard]] std::size_t size() const { return m_states.size(); }

private:
    std::vector<State> m_states{State{}};
    std::size_t m_at = 0; ///< index of the current state
    int m_gesture = 0;    ///< gesture of the current entry
};

} // namespace sparkout
