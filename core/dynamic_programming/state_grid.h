// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/grid.h"
#include "core/project/cycle.h"
#include "core/project/project.h"
#include "core/quality/constraints.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// The coordinate grid of PEREVERZEV1999, figure 5, cell by cell, as the published rule fills it.
///
/// The stock is divided into N levels, n = 0 the whole of it and n = N none left; m is a feed of
/// the search. A cell [n, m] is the state in which level n was reached with feed m. Of all moves
/// into it from the states [n − 1, m'] that are admissible the quickest is kept (eq. 27),
///
///     T[n,m] = min over m' of ( T[n−1,m'] + τ ),   T[0,0] = 0,   m* = the m' of the least,
///
/// the least T[N,m] is the time of the cycle, and its feeds are read back along m*.
///
/// τ is simulated from the state that was kept in [n − 1, m'], with every radius as its cycle left
/// it: the rule as printed, on the exact process. A move is admissible when its passes break no
/// limit (of sections that deflect each other: when they do not burn) and, into level N, when the
/// whole cycle holds as any other cycle of the program must.
/// Moves of one feed in a row are one stage; beyond the stages allowed a move is struck out, which
/// is the source's limit by the commands of the gauge. A level that the move before it passed
/// already is reached at once, τ = 0.
///
/// Levels are gauged, so the grid is of cycles under gauge control.
namespace sparkout {

inline constexpr int mostStockLevels = 40;
inline constexpr std::size_t mostGridFeeds = 40;

struct StateGridSize {
    int levels = 10; ///< N, as the source has it
    int stages = 2;  ///< at most
    friend bool operator==(const StateGridSize&, const StateGridSize&) = default;
};

/// How a move into a state ended.
enum class MoveEnd {
    noState,       ///< nothing was kept where it would begin
    rises,         ///< its feed is above the one before, which the search forbids
    tooManyStages, ///< it would begin one stage more than allowed
    broken,        ///< a limit is broken
    notReached,    ///< the cycle ends before the level
    slower,        ///< admissible, but another is quicker
    kept,          ///< m*
};

struct StateMove {
    MoveEnd end = MoveEnd::noState;
    double move_s = 0;                    ///< τ; as far as it was run
    double time_s = 0;                    ///< T[n−1,m'] + τ
    std::optional<ConstraintKind> broken; ///< what it breaks
};

struct GridState {
    std::optional<double> time_s; ///< T[n,m]; nothing: no admissible move
    std::size_t from = 0;         ///< m*; of level 1 the feed itself, from the blank
    int stages = 0;               ///< of the way here
    std::vector<StateMove> moves; ///< by m'; of level 1 the only one, from the blank
};

enum class StateGridFault { none, noSearch, noFeeds, positionControl };

/// The filled grid: an immutable value.
struct StateGrid {
    Project project; ///< with the search whose cycles the grid has
    StateGridSize size;
    std::vector<StageSetting> feeds;            ///< by m, rising
    std::vector<double> stock_mm;               ///< left at the levels 0 … N
    std::vector<std::vector<GridState>> states; ///< by level, from 1, and feed
    std::vector<std::size_t> path;              ///< feeds of the levels 1 … N; empty: none found
    std::optional<double> time_s;               ///< least T[N,m]
    Cycle cycle;                                ///< the path as a project states it

    [[nodiscard]] const GridState& state(int level, std::size_t feed) const {
        return states[static_cast<std::size_t>(level - 1)][feed];
    }
    /// Feeds along m* from the blank into a state that was reached.
    [[nodiscard]] std::vector<std::size_t> wayTo(int level, std::size_t feed) const;
};

[[nodiscard]] StateGridFault stateGridFault(const Project& project);
/// Stages as many as the search tries, within the gauge's commands.
[[nodiscard]] StateGridSize usualStateGrid(const Project& project);
/// Within what a grid may have and the gauge's commands.
[[nodiscard]] StateGridSize withinReach(StateGridSize size, const Project& project);

/// The project with a search of exactly the cycles that a grid of this size has: up to so many
/// stages of whole levels, with the feeds of its own search, of more than mostGridFeeds some left
/// out evenly. What is set once for the cycle stays as the machine has it; bounds of single stages
/// and scenarios are left out, as the published rule knows none.
[[nodiscard]] Project withGridSearch(const Project& project, StateGridSize size);

/// Fills the grid; nothing after a stop. Of a project without a fault. `onLevel` receives the
/// levels filled.
[[nodiscard]] std::optional<StateGrid> fillStateGrid(const Project& project, StateGridSize size,
                                                     const std::stop_token& stop = {},
                                                     const std::function<void(int)>& onLevel = {});

} // namespace sparkout
