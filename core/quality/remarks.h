// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/simulation/result.h"

namespace sparkout {

/// What only a run shows to be amiss in its inputs; warnings, like those of validate(). At
/// present: a spark-out of a fixed number whose stage has a stock that the deflection did not give
/// back, so that the gauge ends beyond the drawing's limit [MODEL-7].
[[nodiscard]] Issues remarksOn(const SimulationResult& result);

} // namespace sparkout
