// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/refine.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// What a robust search leaves to those that go on from its answer.
struct RobustTrail {
    std::vector<Project> scenarios; ///< that it added
    int candidates = 0;             ///< cycles that it tried on fresh phases
};

/// The answer of a search of a grid.
struct GridAnswer {
    const Project& asked; ///< the project that was searched
    const Project& best;  ///< with the machine set as the answer has it
    const Cycle& cycle;
    std::optional<RobustTrail> robust; ///< of a robust search
};

/// Refines an answer off the grid; of a robust search in the scenarios that it added, and in fresh
/// ones.
[[nodiscard]] RefineSummary refineAnswer(const GridAnswer& answer, const std::stop_token& stop);

} // namespace sparkout
