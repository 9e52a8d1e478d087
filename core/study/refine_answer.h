// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/refine.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Results of a robust search that a refinement of its answer needs.
struct RobustTrail {
    std::vector<Project> scenarios; ///< scenarios that it added
    int candidates = 0;             ///< number of cycles tried on fresh phases
    bool isCapable = true;          ///< FreshParts::isCapable of the answer
};

/// The answer of a search of a grid.
struct GridAnswer {
    const Project& asked; ///< the project that was searched
    const Project& best;  ///< the project with the machine settings of the answer
    const Cycle& cycle;
    std::optional<RobustTrail> robust; ///< only for a robust search
};

/// Refines an answer off the grid; the answer of a robust search in the scenarios that it added and
/// in fresh ones.
[[nodiscard]] RefineSummary refineAnswer(const GridAnswer& answer, const std::stop_token& stop);

} // namespace sparkout
