// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/state_grid.h"
#include "core/optimisation/optimise.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

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
namespace sparkout {

enum class WrongState {
    struckOut, ///< there is a way into it
    slower,    ///< there is a quicker way into it
    misleads,  ///< the slower way into it is the one to continue
};

/// A state on the path of the proven cycle at which the rule loses that path.
struct StateFault {
    int level = 0;
    std::size_t feed = 0;
    WrongState wrong = WrongState::struckOut;
    double reached_s = 0; ///< time at which the proven cycle reaches it
    // Misleads: result of the kept way with the rest of the path.
    std::optional<ConstraintKind> breaks;
    std::optional<double> time_s; ///< time of the continued cycle, if it is feasible and slower
    int stages = 0;               ///< number of stages that it would have
};

struct ExactAnswer {
    SearchStatus status = SearchStatus::stopped;
    std::optional<double> time_s;
    double bound_s = 0; ///< no feasible cycle of the grid is quicker
    Cycle cycle;
    std::vector<std::size_t> path;  ///< feeds of the levels 1 … N
    std::vector<double> reached_s;  ///< times at which it reaches them
    std::int64_t gridSize = 0;      ///< cycles in the grid
    std::vector<StateFault> faults; ///< in the order of the levels; empty if the times are equal

    [[nodiscard]] bool isProved() const {
        return status == SearchStatus::proved || status == SearchStatus::infeasible;
    }
};

[[nodiscard]] ExactAnswer exactAnswer(const StateGrid& grid, const std::stop_token& stop = {},
                                      const std::function<void(const SearchProgress&)>& note = {});

} // namespace sparkout
