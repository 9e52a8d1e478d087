// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamic_programming/level_moves.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/optimisation.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

/// A stage for each level: the grid of states decides how stages follow each other.
Project byLevels(Project searched, int levels) {
    searched.optimisation->stages = {static_cast<double>(levels)};
    return searched;
}

GridCycle mergedStages(const std::vector<std::size_t>& path) {
    GridCycle merged;
    for (const std::size_t feed : path) {
        if (merged.empty() || merged.back().setting != feed) {
            merged.push_back({feed, 0});
        }
        ++merged.back().steps;
    }
    return merged;
}

} // namespace

LevelMoves::LevelMoves(const Project& searched, StateGridSize size, const std::stop_token& stop)
    : m_stop(stop)
    , m_project(byLevels(searched, size.levels))
    , m_grid(m_project)
    , m_runner(m_project, m_grid, stop)
    , m_runs(m_project, m_grid, m_runner, StageRuns::Bounds::no) {}

CyclePrefix LevelMoves::blank() const {
    CyclePrefix prefix;
    prefix.stages = m_grid.stageCounts().front();
    prefix.keep(m_runner.begin(prefix.stages));
    return prefix;
}

LevelMoves::Reached LevelMoves::move(const CyclePrefix& from, std::size_t feed) const {
    Reached reached;
    const bool last = from.isBeforeLast();
    const int taken = last ? 0 : from.taken + 1;
    std::shared_ptr<CycleSteps> steps = from.steps->copy();
    SearchCounts counts;
    const std::optional<StageRuns::End> end = m_runs.runTo(taken, from, *steps, feed, counts);
    reached.move.time_s = steps->run().time_s();
    reached.move.move_s = reached.move.time_s - from.time_s;
    if (!end) {
        const auto cut = std::ranges::find_if(counts.cuts, [](long long n) { return n > 0; });
        const bool isCut = cut != counts.cuts.end();
        reached.move.end = isCut ? MoveEnd::broken : MoveEnd::notReached;
        if (isCut) {
            reached.move.broken = static_cast<ConstraintKind>(cut - counts.cuts.begin());
        }
        return reached;
    }
    reached.move.end = MoveEnd::slower;
    if (last) {
        reached.beyondSize = m_runner.cuts().brokenAtEnd(steps->run());
    }
    reached.there = m_runs.after(from, feed, *end, taken);
    reached.there->keep(std::move(steps));
    return reached;
}

Cycle LevelMoves::cycle(const std::vector<std::size_t>& path) const {
    return m_grid.cycle(mergedStages(path));
}

int LevelMoves::stagesOf(const std::vector<std::size_t>& path) {
    return static_cast<int>(mergedStages(path).size());
}

LevelMoves::Judged LevelMoves::judge(const std::vector<std::size_t>& path) const {
    Project project = m_project;
    *project.cycle = cycle(path);
    const SimulationResult result = simulateUnchecked(project, nullptr, m_stop);
    Judged judged;
    judged.completed = result.status == RunStatus::completed;
    judged.time_s = result.time_s;
    judged.time_us = comparedTime_us(result.time_s);
    if (judged.completed) {
        judged.leastMargin = std::numeric_limits<double>::infinity();
        double worst = std::numeric_limits<double>::infinity();
        for (const ConstraintResult& each : evaluateConstraints(result)) {
            judged.leastMargin = std::min(judged.leastMargin, each.relativeMargin);
            if (!each.holds && each.relativeMargin < worst) {
                worst = each.relativeMargin;
                judged.broken = each.kind;
            }
        }
    }
    return judged;
}

} // namespace sparkout
