// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <limits>

namespace sparkout {

inline constexpr std::int64_t noTime_us = std::numeric_limits<std::int64_t>::max();

/// The time that cycles are compared by.
[[nodiscard]] std::int64_t comparedTime_us(double time_s);

/// Whether a is the better of two feasible cycles.
[[nodiscard]] bool isBetter(const FeasibleCycle& a, const FeasibleCycle& b, const Grid& grid);

/// What a judge adds up beside the best cycle.
struct SearchCounts {
    long long evaluations = 0, visits = 0;
    std::array<long long, constraintKinds> cuts{};
    void add(const SearchCounts& other);
};

/// Decides on cycles by their simulation, and keeps the best.
class Judge {
public:
    Judge(const Grid& grid, const std::vector<Project>& scenarios)
        : m_grid(grid), m_scenarios(scenarios) {}

    /// A cycle of the grid as it was run; one that is slower than the best is not looked at
    /// further. True: it is the new best.
    bool judge(const GridCycle& cycle, const SimulationResult& result);
    /// A best cycle found elsewhere.
    bool offer(const FeasibleCycle& found);

    [[nodiscard]] const std::optional<FeasibleCycle>& best() const { return m_best; }
    [[nodiscard]] std::int64_t bestTime_us() const { return m_best ? m_best->time_us : noTime_us; }
    SearchCounts counts;

private:
    /// The least relative margin; nothing when a requirement fails.
    std::optional<double> leastMargin(const SimulationResult& result);

    const Grid& m_grid;
    std::vector<Project> m_scenarios;
    std::optional<FeasibleCycle> m_best;
};

} // namespace sparkout
