// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

namespace sparkout {

/// As much of accuracyOf() as the drawing's tolerances need.
[[nodiscard]] PartAccuracy requiredAccuracy(const SimulationResult& result);

/// Diameters, runouts, form and roughness against the drawing [MODEL-8].
[[nodiscard]] std::vector<ConstraintResult> drawingConstraints(const SimulationResult& result,
                                                               const PartAccuracy& accuracy);

/// Places and radii of the sections, as the accuracy of the part takes them.
[[nodiscard]] std::vector<SectionShape> shapesOf(const SimulationResult& result);

} // namespace sparkout
