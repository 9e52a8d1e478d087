// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/project.h"
#include "core/quality/constraints.h"
#include "core/search/cycle_runner.h"
#include "core/search/grid.h"
#include "core/search/optimise.h"
#include "core/search/stage_runs.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// The coordinate grid of PEREVERZEV1999, figure 5, cell by cell, as the published rule fills it.
///
/// The stock is divided into N levels, from n = 0, the whole stock, to n = N, none left; m is a
/// feed of the search. A cell [n, m] is the state in which level n was reached with feed m. The
/// quickest of all admissible moves into it from the states [n − 1, m'] is kept (eq. 27),
///
///     T[n,m] = min over m' of ( T[n−1,m'] + τ ),   T[0,0] = 0,   m* = the m' of the least,
///
/// the least T[N,m] is the time of the cycle, and its feeds are read back along m*.
///
/// τ is simulated from the state that was kept in [n − 1, m'], with every radius as its cycle left
/// it: this is the printed rule applied to the exact process. A move is admissible if its passes
/// exceed no limit (of coupled sections: if they do not burn) and, into level N, if the whole cycle
/// is feasible like any other cycle of the program. Successive moves with one feed are one stage; a
/// move beyond the allowed number of stages is struck out, which is the source's limit by the
/// commands of the gauge. A level that the preceding move has already passed is reached at once, τ
/// = 0.
///
/// The gauge detects the levels, so the grid contains only cycles under gauge control.

namespace sparkout {

inline constexpr int mostStockLevels = 40;
inline constexpr std::size_t mostGridFeeds = 40;

struct StateGridSize {
    int levels = 10; ///< N, by the source
    int stages = 2;  ///< greatest number of stages
    friend bool operator==(const StateGridSize&, const StateGridSize&) = default;
};

/// The end of a move into a state.
enum class MoveEnd {
    noState,       ///< no way was kept in its initial state
    rises,         ///< its feed is above the previous one, which the search forbids
    tooManyStages, ///< it would need one stage more than allowed
    broken,        ///< a limit is broken
    notReached,    ///< the cycle ends before the level
    slower,        ///< admissible, but another move is quicker
    kept,          ///< m*
};

struct StateMove {
    MoveEnd end = MoveEnd::noState;
    double move_s = 0;                    ///< τ, as far as it was run
    double time_s = 0;                    ///< T[n−1,m'] + τ
    std::optional<ConstraintKind> broken; ///< violated requirement
};

struct GridState {
    std::optional<double> time_s; ///< T[n,m]; empty: no admissible move
    std::size_t from = 0;         ///< m*; in level 1 the feed itself
    int stages = 0;               ///< number of stages of the way to this state
    std::vector<StateMove> moves; ///< by m'; in level 1 only one, from the blank
};

enum class StateGridFault { none, noSearch, noFeeds, positionControl };

/// The filled grid: an immutable value.
struct StateGrid {
    Project project; ///< with a search of the cycles of the grid
    StateGridSize size;
    std::vector<StageSetting> feeds;            ///< by m, rising
    std::vector<double> stock_mm;               ///< remaining stock at the levels 0 … N
    std::vector<std::vector<GridState>> states; ///< by level, from 1, and feed
    std::vector<std::size_t> path;              ///< feeds of the levels 1 … N; empty: none found
    std::optional<double> time_s;               ///< least T[N,m]
    Cycle cycle;                                ///< the path as a project's cycle

    [[nodiscard]] const GridState& state(int level, std::size_t feed) const {
        return states[static_cast<std::size_t>(level - 1)][feed];
    }
    /// Returns the feeds along m* from the blank to a reached state.
    [[nodiscard]] std::vector<std::size_t> wayTo(int level, std::size_t feed) const;
};

[[nodiscard]] StateGridFault stateGridFault(const Project& project);
/// Returns the usual size, with as many stages as the search tries, within the gauge's commands.
[[nodiscard]] StateGridSize usualStateGrid(const Project& project);
/// Limits a size to the greatest grid and the gauge's commands.
[[nodiscard]] StateGridSize withinReach(StateGridSize size, const Project& project);

/// Returns the project with a search of exactly the cycles of a grid of this size: up to
/// `size.stages` stages of whole levels, with the feeds of its own search; of more than
/// mostGridFeeds feeds some are left out at even intervals. Machine settings are unchanged; bounds
/// of single stages and scenarios are removed, as the published rule has none.
[[nodiscard]] Project withGridSearch(const Project& project, StateGridSize size);

/// Fills the grid of a project without a fault; returns nullopt after a stop. `onLevel` receives
/// the number of levels filled.
[[nodiscard]] std::optional<StateGrid> fillStateGrid(const Project& project, StateGridSize size,
                                                     const std::stop_token& stop = {},
                                                     const std::function<void(int)>& onLevel = {});

/// Moves between levels of stock, each simulated from the previous state.
class LevelMoves {
public:
    /// Requires a project with the search of a grid.
    LevelMoves(const Project& searched, StateGridSize size, const std::stop_token& stop);

    /// Returns the prefix of the blank, with no level reached.
    [[nodiscard]] CyclePrefix blank() const;
    struct Reached {
        StateMove move;                   ///< end `slower`: admissible by the limits of its passes
        std::optional<CyclePrefix> there; ///< prefix at its level, if reached
        std::optional<ConstraintKind>
            beyondSize; ///< move into the last level: requirement violated by a diameter
    };
    [[nodiscard]] Reached move(const CyclePrefix& from, std::size_t feed) const;

    /// Result of the whole cycle of a path, run with the project's stocks.
    struct Judged {
        bool completed = false;
        std::int64_t time_us = 0;
        double time_s = 0;
        double leastMargin = 0;
        std::optional<ConstraintKind> broken;
        [[nodiscard]] bool holds() const { return completed && !broken; }
    };
    [[nodiscard]] Judged judge(const std::vector<std::size_t>& path) const;
    [[nodiscard]] Cycle cycle(const std::vector<std::size_t>& path) const;

    [[nodiscard]] const Grid& grid() const { return m_grid; }
    [[nodiscard]] static int stagesOf(const std::vector<std::size_t>& path);

private:
    std::stop_token m_stop;
    Project m_project; ///< with one stage per level
    Grid m_grid;
    CycleRunner m_runner;
    StageRuns m_runs;
};

enum class WrongState {
    struckOut, ///< there is a way into it
    slower,    ///< there is a quicker way into it
    misleads,  ///< the slower way into it is the one to continue
};

/// A state on the path of the proven cycle at which the rule loses that path.
struct StateDifference {
    int level = 0;
    std::size_t feed = 0;
    WrongState wrong = WrongState::struckOut;
    double reached_s = 0; ///< time at which the proven cycle reaches it
    // Misleads: result of the kept way with the rest of the path.
    std::optional<ConstraintKind> breaks;
    std::optional<double> time_s; ///< time of the continued cycle, if it is feasible and slower
    int stages = 0;               ///< number of stages that it would have
};

/// The proven quickest cycle of a grid of states compared with that of the published rule, and the
/// states in which the rule fails.
///
/// The pruned search covers the same cycles: the same feeds, whole levels, as many stages. Its
/// answer is a path through the grid. Where the rule misses it, or finds a slower one, at least one
/// state on that path has a kept way other than the path's, and a run shows one of these faults:
///
/// * the state was struck out, although the path reaches it within every limit;
/// * the time kept in it is not the least: the path reaches it earlier;
/// * the kept way reaches it no later but continues worse: with the remaining feeds of the path it
///   violates a requirement, has too many stages or ends later. The quickest way into a state is
///   then not the one to continue, because the deflections stored by all radii are part of the
///   state.
struct ExactAnswer {
    SearchStatus status = SearchStatus::stopped;
    std::optional<double> time_s;
    double bound_s = 0; ///< no feasible cycle of the grid is quicker
    Cycle cycle;
    std::vector<std::size_t> path; ///< feeds of the levels 1 … N
    std::vector<double> reached_s; ///< times at which it reaches them
    std::int64_t gridSize = 0;     ///< cycles in the grid
    std::vector<StateDifference>
        faults; ///< in the order of the levels; empty if the times are equal

    [[nodiscard]] bool isProved() const {
        return status == SearchStatus::proved || status == SearchStatus::infeasible;
    }
};

[[nodiscard]] ExactAnswer exactAnswer(const StateGrid& grid, const std::stop_token& stop = {},
                                      const std::function<void(const SearchProgress&)>& note = {});

} // namespace sparkout
