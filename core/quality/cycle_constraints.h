// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

namespace sparkout {

/// The visit nearest to burning, with its numbers [MODEL-8].
struct BurnState {
    BurnVisit visit;
    double limitDepth_mm = 0;   ///< the depth of cut that is just allowed for the stock left
    double rise_k = 0;          ///< T at the depth of the stock left, which U_burn limits
    double damagedDepth_mm = 0; ///< h_d, which the stock left limits
};
/// Nothing where no rise that burns is given. Where nothing was cut, a depth of 0 with no stock
/// left.
[[nodiscard]] std::optional<BurnState> burnStateOf(const SimulationResult& result);

/// Burn, self-sharpening, power, the machine's ranges and the gauge's commands: what a cycle is
/// held against beside the drawing [MODEL-8].
[[nodiscard]] std::vector<ConstraintResult> cycleConstraints(const SimulationResult& result);

} // namespace sparkout
