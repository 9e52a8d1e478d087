// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

namespace sparkout {

/// As much of accuracyOf() as the drawing's tolerances need.
[[nodiscard]] PartAccuracy requiredAccuracy(const SimulationResult& result);

/// Diameters, runouts, form and roughness against the drawing [MODEL-8].
[[nodiscard]] std::vector<ConstraintResult> drawingConstraints(const SimulationResult& result,
                                                               const PartAccuracy& accuracy);

} // namespace sparkout
