// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/judge.h"

#include <algorithm>
#include <utility>

namespace sparkout {

bool isBetter(const FeasibleCycle& a, const FeasibleCycle& b, const Grid& grid) {
    if (a.time_us != b.time_us) {
        return a.time_us < b.time_us;
    }
    if (a.leastRelativeMargin != b.leastRelativeMargin) {
        return a.leastRelativeMargin > b.leastRelativeMargin;
    }
    return grid.before(a.cycle, b.cycle);
}

Judge::Judge(const Grid& grid, const std::vector<Project>& scenarios) : m_grid(grid) {
    m_scenarios.reserve(scenarios.size());
    for (const Project& scenario : scenarios) {
        m_scenarios.emplace_back(scenario, grid);
    }
}

std::optional<double> Judge::leastMargin(const SimulationResult& result) {
    if (result.status != RunStatus::completed) {
        return std::nullopt;
    }
    bool holds = true;
    double least = std::numeric_limits<double>::infinity();
    for (const ConstraintResult& constraint : worstByKind(evaluateConstraints(result))) {
        least = std::min(least, constraint.relativeMargin);
        if (!constraint.holds) {
            holds = false;
            ++counts.cuts[static_cast<std::size_t>(constraint.kind)];
        }
    }
    return holds ? std::optional(least) : std::nullopt;
}

bool Judge::judge(const GridCycle& cycle, const SimulationResult& result) {
    ++counts.evaluations;
    FeasibleCycle found{cycle, comparedTime_us(result.time_s), 0};
    if (found.time_us > bestTime_us()) {
        return false;
    }
    std::optional<double> margin = leastMargin(result);
    for (std::size_t i = 0; margin && i < m_scenarios.size(); ++i) {
        const auto other = m_scenarios[i].run(cycle, noTime_us, counts);
        const std::optional<double> there = other ? leastMargin(*other) : std::nullopt;
        margin = there ? std::optional(std::min(*margin, *there)) : std::nullopt;
        if (!margin) {
            std::swap(m_scenarios[0], m_scenarios[i]);
        }
    }
    if (!margin) {
        return false;
    }
    found.leastRelativeMargin = *margin;
    return offer(found);
}

bool Judge::decide(const GridCycle& cycle, CycleRunner& runner) {
    if (const auto result = runner.run(cycle, bestTime_us(), counts)) {
        return judge(cycle, *result);
    }
    ++counts.evaluations;
    return false;
}

bool Judge::offer(const FeasibleCycle& found) {
    if (m_best && !isBetter(found, *m_best, m_grid)) {
        return false;
    }
    m_best = found;
    return true;
}

} // namespace sparkout
