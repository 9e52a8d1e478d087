// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/simulation/result.h"

namespace sparkout {

/// What only a run shows to be amiss in its inputs; warnings, like those of validate(): a spark-out
/// of a fixed number whose stage has a stock that the deflection did not give back, so that the
/// gauge ends beyond the drawing's limit; a stage whose stock was gone before it began [MODEL-7];
/// a dwell that whole revolutions make another one [MODEL-5]; a factor of Ra far from that of the
/// measured Ra [MODEL-8].
[[nodiscard]] Issues remarksOn(const SimulationResult& result);

} // namespace sparkout
