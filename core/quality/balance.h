// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/cutting.h"

namespace sparkout {

/// The elastic balance of one radius in one pass [MODEL-3] with its numbers: a + γ·P_y(a) = h, for
/// an effective width b [mm], a compliance γ [mm/N] and h = t_П less the depth below first touch
/// [mm], above 0. The depth of cut a, its last step but one, comes from the engine's pass over one
/// radius; the last step is the remaining deflection γ·P_y. With a threshold, where h is not above
/// γ·b·F'_0, the force is h/γ and a is 0.
[[nodiscard]] FormulaSheet balanceSheet(const Project& project, double b, double gamma, double h);

} // namespace sparkout
