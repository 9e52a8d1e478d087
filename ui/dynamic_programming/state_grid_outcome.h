// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/exact_answer.h"
#include "core/dynamic_programming/state_grid.h"
#include "ui/session/job.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace sparkout {

/// A grid of dynamic programming as an immutable value of the window. The proven answer comes later
/// than the grid.
struct StateGridOutcome {
    Project project; ///< unchanged, with its own search
    StateGrid grid;
    std::optional<ExactAnswer> exact;
};

using StateGridOutcomePtr = std::shared_ptr<const StateGridOutcome>;

/// The parts that the progress of a proof is counted in.
inline constexpr std::int64_t gridProofParts = 1000;

/// Null after a stop.
[[nodiscard]] StateGridOutcomePtr filledGrid(const Project& project, StateGridSize size,
                                             const Job::Means& means);
/// With the proven answer; after a stop with what is known.
[[nodiscard]] StateGridOutcomePtr provenGrid(const StateGridOutcome& filled,
                                             const Job::Means& means);

/// A moment of filling a grid: states are filled level by level, in each from the least feed on;
/// then the path is read back from the last level.
struct GridMoment {
    int level = 0; ///< level of the current state; 0: the blank, nothing is filled
    std::size_t feed = 0;
    int stepsBack = 0; ///< states read back so far, with that one
};

/// The number of moments after that of the blank.
[[nodiscard]] int momentCount(const StateGrid& grid);
[[nodiscard]] GridMoment momentAt(const StateGrid& grid, int number);
/// The moment in which a state is filled.
[[nodiscard]] int momentOf(const StateGrid& grid, int level, std::size_t feed);
/// The moment of the last filled state.
[[nodiscard]] int momentsOfFilling(const StateGrid& grid);

} // namespace sparkout
