// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamic_programming/exact_answer.h"

#include "core/dynamic_programming/level_moves.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

std::vector<std::size_t> pathOf(const GridCycle& cycle, int levels) {
    std::vector<std::size_t> path;
    for (const GridStage& stage : cycle) {
        const bool last = &stage == &cycle.back();
        const auto ends = last ? static_cast<std::size_t>(levels)
                               : path.size() + static_cast<std::size_t>(stage.steps);
        path.resize(ends, stage.setting);
    }
    return path;
}

/// The times at which a path reaches its levels.
std::vector<double> timesOf(const LevelMoves& moves, const std::vector<std::size_t>& path) {
    std::vector<double> reached_s;
    CyclePrefix way = moves.blank();
    for (const std::size_t feed : path) {
        LevelMoves::Reached reached = moves.move(way, feed);
        if (!reached.there) {
            break;
        }
        way = std::move(*reached.there);
        reached_s.push_back(reached.move.time_s);
    }
    return reached_s;
}

/// The fault of a state on the path, if it has one.
std::optional<StateFault> faultAt(const StateGrid& grid, const LevelMoves& moves,
                                  const ExactAnswer& exact, int level) {
    const auto at = static_cast<std::size_t>(level - 1);
    StateFault fault;
    fault.level = level;
    fault.feed = exact.path[at];
    fault.reached_s = exact.reached_s[at];
    const GridState& state = grid.state(level, fault.feed);
    if (!state.time_s) {
        fault.wrong = WrongState::struckOut;
        return fault;
    }
    if (comparedTime_us(*state.time_s) > comparedTime_us(fault.reached_s)) {
        fault.wrong = WrongState::slower;
        return fault;
    }
    std::vector<std::size_t> path = grid.wayTo(level, fault.feed);
    path.insert(path.end(), exact.path.begin() + level, exact.path.end());
    if (path == exact.path) {
        return std::nullopt;
    }
    fault.wrong = WrongState::misleads;
    fault.stages = LevelMoves::stagesOf(path);
    const LevelMoves::Judged judged = moves.judge(path);
    fault.breaks = judged.broken;
    if (judged.holds()) {
        fault.time_s = judged.time_s;
    }
    const bool asGood = judged.holds() && fault.stages <= grid.size.stages
                        && judged.time_us <= comparedTime_us(*exact.time_s);
    return asGood ? std::nullopt : std::optional(fault);
}

} // namespace

ExactAnswer exactAnswer(const StateGrid& grid, const std::stop_token& stop,
                        const std::function<void(const SearchProgress&)>& note) {
    SearchOptions options;
    options.stop = stop;
    options.onProgress = note;
    const SearchSummary summary = optimise(grid.project, options);
    ExactAnswer exact;
    exact.status = summary.status;
    exact.bound_s = summary.bound_s;
    exact.gridSize = summary.gridSize;
    if (!summary.best) {
        return exact;
    }
    exact.time_s = summary.best->time_s;
    exact.cycle = summary.cycle;
    exact.path = pathOf(summary.best->cycle, grid.size.levels);
    const LevelMoves moves(grid.project, grid.size, {});
    exact.reached_s = timesOf(moves, exact.path);
    const bool missed =
        !grid.time_s || comparedTime_us(*grid.time_s) > comparedTime_us(*exact.time_s);
    for (int level = 1; missed && level <= static_cast<int>(exact.reached_s.size()); ++level) {
        if (const auto fault = faultAt(grid, moves, exact, level)) {
            exact.faults.push_back(*fault);
        }
    }
    return exact;
}

} // namespace sparkout
