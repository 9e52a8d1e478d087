// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/judge.h"

#include "core/optimisation/full_search.h"
#include "core/optimisation/pruned_search.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

std::int64_t comparedTime_us(double time_s) {
    return std::llround(time_s * 1e6);
}

bool isBetter(const FeasibleCycle& a, const FeasibleCycle& b, const Grid& grid) {
    if (a.time_us != b.time_us) {
        return a.time_us < b.time_us;
    }
    if (a.leastRelativeMargin != b.leastRelativeMargin) {
        return a.leastRelativeMargin > b.leastRelativeMargin;
    }
    return grid.before(a.cycle, b.cycle);
}

void SearchCounts::add(const SearchCounts& other) {
    evaluations += other.evaluations;
    visits += other.visits;
    for (std::size_t kind = 0; kind < cuts.size(); ++kind) {
        cuts[kind] += other.cuts[kind];
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
    for (Project& scenario : m_scenarios) {
        if (!margin) {
            return false;
        }
        scenario.cycle = result.project.cycle;
        const SimulationResult other = simulate(scenario);
        counts.visits += other.visits;
        const std::optional<double> there = leastMargin(other);
        margin = there ? std::optional(std::min(*margin, *there)) : std::nullopt;
    }
    if (!margin) {
        return false;
    }
    found.leastRelativeMargin = *margin;
    return offer(found);
}

bool Judge::offer(const FeasibleCycle& found) {
    if (m_best && !isBetter(found, *m_best, m_grid)) {
        return false;
    }
    m_best = found;
    return true;
}

SearchSummary optimise(const Project& project, const SearchOptions& options) {
    const Grid grid(project);
    SearchSummary summary = options.method == SearchMethod::full
                                ? fullSearch(project, grid, options)
                                : prunedSearch(project, grid, options);
    summary.gridSize = grid.size();
    if (summary.best) {
        summary.cycle = grid.cycle(summary.best->cycle);
    }
    return summary;
}

} // namespace sparkout
