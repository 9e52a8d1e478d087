// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"
#include "core/quality/constraints.h"

#include <optional>

namespace sparkout {

/// The calculation of a requirement's value at its worst place: the last step gives the value, for
/// burn and self-sharpening the limit of the depth of cut. Empty for values read off (diameters,
/// settings), for the power of coupled sections, which is an integral, and where nothing was cut.
[[nodiscard]] std::optional<FormulaSheet> constraintSheet(const SimulationResult& result,
                                                          const PartAccuracy& accuracy,
                                                          const ConstraintResult& constraint);

} // namespace sparkout
