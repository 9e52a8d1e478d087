// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/state_grid.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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
std::optional<StateDifference> faultAt(const StateGrid& grid, const LevelMoves& moves,
                                       const ExactAnswer& exact, int level) {
    const auto at = static_cast<std::size_t>(level - 1);
    StateDifference fault;
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

namespace {

/// This number of the values, including the first and the last, as evenly spaced as possible.
std::vector<double> thinned(const std::vector<double>& values, std::size_t count) {
    if (count >= values.size()) {
        return values;
    }
    std::vector<double> some;
    for (std::size_t i = 0; i < count; ++i) {
        some.push_back(values[count == 1 ? 0 : (i * (values.size() - 1)) / (count - 1)]);
    }
    return some;
}

std::vector<double> risingLevels(const Levels& levels) {
    if (levelCount(levels) > mostSettings) {
        return {};
    }
    std::vector<double> values = levelValues(levels);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

class GridFiller {
public:
    GridFiller(const Project& project, StateGridSize size, const std::stop_token& stop)
        : m_stop(stop)
        , m_size(size)
        , m_searched(withGridSearch(project, size))
        , m_moves(m_searched, size, stop) {}

    std::optional<StateGrid> fill(const std::function<void(int)>& onLevel) {
        m_filled.project = m_searched;
        m_filled.size = m_size;
        m_filled.feeds = m_moves.grid().settings();
        for (int n = 0; n <= m_size.levels; ++n) {
            m_filled.stock_mm.push_back(n == m_size.levels ? 0 : m_moves.grid().remainder(n));
        }
        for (int n = 1; n <= m_size.levels; ++n) {
            fillLevel(n);
            if (m_stop.stop_requested()) {
                return std::nullopt;
            }
            if (onLevel) {
                onLevel(n);
            }
        }
        readBack();
        return std::move(m_filled);
    }

private:
    using Ways = std::vector<std::optional<CyclePrefix>>; ///< kept ways, by feed

    void fillLevel(int level) {
        const std::size_t feeds = m_filled.feeds.size();
        Ways next(feeds);
        std::vector<GridState>& states = m_filled.states.emplace_back(feeds);
        for (std::size_t m = 0; m < feeds && !m_stop.stop_requested(); ++m) {
            if (level == m_size.levels) {
                fillLast(states[m], level, m);
            } else {
                fillState(states[m], level, m, next[m]);
            }
        }
        m_ways = std::move(next);
    }

    /// The feeds before this level, the quickest first, which is kept among equal times.
    [[nodiscard]] std::vector<std::size_t> byTime(int level) const {
        std::vector<std::size_t> order(m_filled.feeds.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const std::vector<GridState>& before = m_filled.states[static_cast<std::size_t>(level - 2)];
        const auto time = [&](std::size_t m) {
            return before[m].time_s.value_or(std::numeric_limits<double>::infinity());
        };
        std::ranges::stable_sort(order,
                                 [&](std::size_t a, std::size_t b) { return time(a) < time(b); });
        return order;
    }

    struct From {
        std::size_t move; ///< index of the move in its state
        std::size_t feed; ///< m'; for the first level the feed of the move
        const CyclePrefix* way;
        int stages; ///< including the move
    };
    /// The possible beginnings of moves into a state; the others are struck out.
    std::vector<From> beginnings(GridState& state, int level, std::size_t m) {
        if (level == 1) {
            state.moves.resize(1);
            if (!m_blank) {
                m_blank = m_moves.blank();
            }
            return {{0, m, &*m_blank, 1}};
        }
        std::vector<From> from;
        state.moves.resize(m_filled.feeds.size());
        for (const std::size_t before : byTime(level)) {
            StateMove& move = state.moves[before];
            const GridState& origin = m_filled.state(level - 1, before);
            const int stages = origin.stages + (before == m ? 0 : 1);
            if (!origin.time_s) {
                move.end = MoveEnd::noState;
            } else if (!m_moves.grid().mayFollow(before, m)) {
                move.end = MoveEnd::rises;
            } else if (stages > m_size.stages) {
                move.end = MoveEnd::tooManyStages;
            } else {
                from.push_back({before, before, &*m_ways[before], stages});
            }
        }
        return from;
    }

    static void keep(GridState& state, const From& from) {
        if (state.time_s) {
            for (StateMove& move : state.moves) {
                move.end = move.end == MoveEnd::kept ? MoveEnd::slower : move.end;
            }
        }
        state.moves[from.move].end = MoveEnd::kept;
        state.time_s = state.moves[from.move].time_s;
        state.from = from.feed;
        state.stages = from.stages;
    }

    void fillState(GridState& state, int level, std::size_t m, std::optional<CyclePrefix>& way) {
        for (const From& from : beginnings(state, level, m)) {
            LevelMoves::Reached reached = m_moves.move(*from.way, m);
            state.moves[from.move] = reached.move;
            if (reached.there && (!state.time_s || reached.move.time_s < *state.time_s)) {
                keep(state, from);
                way = std::move(reached.there);
            }
        }
    }

    /// The quickest are judged first: once one is feasible the slower ones need not be.
    void fillLast(GridState& state, int level, std::size_t m) {
        std::vector<From> ended;
        for (const From& from : beginnings(state, level, m)) {
            LevelMoves::Reached reached = m_moves.move(*from.way, m);
            StateMove& move = state.moves[from.move];
            move = reached.move;
            if (reached.beyondSize) {
                move.end = MoveEnd::broken;
                move.broken = reached.beyondSize;
            } else if (reached.there) {
                ended.push_back(from);
            }
        }
        const auto time_us = [&](const From& from) {
            return comparedTime_us(state.moves[from.move].time_s);
        };
        std::ranges::stable_sort(ended, {}, time_us);
        std::optional<std::int64_t> kept_us;
        double margin = 0;
        for (const From& from : ended) {
            if (kept_us && time_us(from) > *kept_us) {
                break;
            }
            std::vector<std::size_t> path;
            if (level > 1) {
                path = m_filled.wayTo(level - 1, from.feed);
            }
            path.push_back(m);
            const LevelMoves::Judged judged = m_moves.judge(path);
            StateMove& move = state.moves[from.move];
            if (!judged.holds()) {
                move.end = judged.completed ? MoveEnd::broken : MoveEnd::notReached;
                move.broken = judged.broken;
            } else if (!kept_us || judged.leastMargin > margin) {
                keep(state, from);
                kept_us = time_us(from);
                margin = judged.leastMargin;
                m_margins.resize(m_filled.feeds.size());
                m_margins[m] = margin;
            }
        }
    }

    /// Of equal times the largest margin wins, as in every search.
    void readBack() {
        const std::vector<GridState>& last = m_filled.states.back();
        std::optional<std::size_t> best;
        for (std::size_t m = 0; m < last.size(); ++m) {
            if (!last[m].time_s) {
                continue;
            }
            const std::int64_t time_us = comparedTime_us(*last[m].time_s);
            const std::int64_t best_us = best ? comparedTime_us(*last[*best].time_s) : noTime_us;
            if (time_us < best_us || (time_us == best_us && m_margins[m] > m_margins[*best])) {
                best = m;
            }
        }
        if (best) {
            m_filled.path = m_filled.wayTo(m_size.levels, *best);
            m_filled.time_s = last[*best].time_s;
            m_filled.cycle = m_moves.cycle(m_filled.path);
        }
    }

    std::stop_token m_stop;
    StateGridSize m_size;
    Project m_searched;
    LevelMoves m_moves;
    StateGrid m_filled;
    Ways m_ways; ///< to the previous level
    std::optional<CyclePrefix> m_blank;
    std::vector<double> m_margins; ///< margins of the cycles into the last level's states
};

} // namespace

std::vector<std::size_t> StateGrid::wayTo(int level, std::size_t feed) const {
    std::vector<std::size_t> way(static_cast<std::size_t>(level));
    for (int n = level; n >= 1; --n) {
        way[static_cast<std::size_t>(n - 1)] = feed;
        feed = state(n, feed).from;
    }
    return way;
}

StateGridFault stateGridFault(const Project& project) {
    if (!project.optimisation) {
        return StateGridFault::noSearch;
    }
    if (project.gauge->control != Control::gauge) {
        return StateGridFault::positionControl;
    }
    for (const StageFeed& feed : project.operation->feeds) {
        const double count = levelCount((*project.optimisation).*feed.levels);
        if (count < 1 || count > mostSettings) {
            return StateGridFault::noFeeds;
        }
    }
    return StateGridFault::none;
}

StateGridSize withinReach(StateGridSize size, const Project& project) {
    size.levels = std::clamp(size.levels, 1, mostStockLevels);
    size.stages = std::clamp(size.stages, 1, std::min(size.levels, project.gauge->commands));
    return size;
}

StateGridSize usualStateGrid(const Project& project) {
    StateGridSize size;
    if (project.optimisation && !project.optimisation->stages.empty()) {
        size.stages = static_cast<int>(std::ranges::max(project.optimisation->stages));
    }
    return withinReach(size, project);
}

Project withGridSearch(const Project& project, StateGridSize size) {
    const Optimisation& asked = *project.optimisation;
    Optimisation grid;
    grid.stages.clear();
    for (int stages = 1; stages <= size.stages; ++stages) {
        grid.stages.push_back(stages);
    }
    grid.stock_step_mm = project.part->stock_mm / size.levels;
    grid.non_increasing = asked.non_increasing;
    const StageFeed* const axialFeed = project.operation->axial();
    const StageFeed& radialFeed = project.operation->radial();
    std::vector<double> radial = risingLevels(asked.*radialFeed.levels);
    std::vector<double> axial =
        axialFeed ? risingLevels(asked.*axialFeed->levels) : std::vector<double>{0};
    std::size_t radials = radial.size(), axials = axial.size();
    while (radials * axials > mostGridFeeds) {
        --(radials >= axials ? radials : axials);
    }
    grid.*radialFeed.levels = thinned(radial, radials);
    if (axialFeed) {
        grid.*axialFeed->levels = thinned(axial, axials);
    }
    Project searched = project;
    searched.optimisation = std::move(grid);
    searched.runs.clear();
    return searched;
}

std::optional<StateGrid> fillStateGrid(const Project& project, StateGridSize size,
                                       const std::stop_token& stop,
                                       const std::function<void(int)>& onLevel) {
    return GridFiller(project, size, stop).fill(onLevel);
}

} // namespace sparkout
