// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/exact_answer.h"
#include "core/dynamic_programming/state_grid.h"
#include "ui/session/job.h"

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

} // namespace sparkout
