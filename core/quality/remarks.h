// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/simulation/result.h"

namespace sparkout {

/// Faults of the inputs that only a run reveals; warnings, like those of validate(): a spark-out of
/// a fixed number whose stage has a stock that the deflection did not release, so that the gauge
/// ends beyond the drawing's limit; a stage whose stock was removed before it began [MODEL-7]; a
/// dwell changed by rounding to whole revolutions [MODEL-5]; a factor of Ra far from that of the
/// measured Ra [MODEL-8].
[[nodiscard]] Issues remarksOn(const SimulationResult& result);

} // namespace sparkout
