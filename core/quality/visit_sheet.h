// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "core/surface/cutting.h"
#include "core/surface/formula.h"

#include <cstddef>

namespace sparkout {

/// The elastic balance of one radius in one pass [MODEL-3] with its numbers: a + γ·P_y(a) = h, for
/// an effective width b [mm], a compliance γ [mm/N] and h = t_П less the depth below first touch
/// [mm], above 0. The depth of cut a, its last step but one, comes from the engine's pass over one
/// radius; the last step is the remaining deflection γ·P_y. With a threshold, where h is not above
/// γ·b·F'_0, the force is h/γ and a is 0.
[[nodiscard]] FormulaSheet balanceSheet(const Project& project, double b, double gamma, double h);

/// One radius of a recorded pass with its numbers [MODEL-3]: the lag h behind t_П, the elastic
/// balance, and the radius and stock after the cut. Where sections deflect each other or the
/// wheel's contact yields too, the depth of cut is the engine's result, and the deflection is the
/// total.
[[nodiscard]] FormulaSheet visitSheet(const SimulationResult& result, const Trajectory& trajectory,
                                      std::size_t pass, int radius);

} // namespace sparkout
