// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"
#include "core/simulation/result.h"
#include "core/simulation/trajectory.h"

#include <cstddef>

namespace sparkout {

/// One radius of a recorded pass with its numbers [MODEL-3]: the lag h behind t_П, the elastic
/// balance, and the radius and stock after the cut. Where sections deflect each other or the
/// wheel's contact yields too, the depth of cut is the engine's result, and the deflection is the
/// total.
[[nodiscard]] FormulaSheet visitSheet(const SimulationResult& result, const Trajectory& trajectory,
                                      std::size_t pass, int radius);

} // namespace sparkout
