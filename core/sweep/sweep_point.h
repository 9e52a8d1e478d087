// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_run.h"

namespace sparkout {

/// A point with its quantities, before they are aligned with those of all points.
struct MeasuredPoint {
    SweepPoint point;
    std::vector<SweepQuantity> quantities;
};

/// Everything a sweep reports of one run.
[[nodiscard]] MeasuredPoint measurePoint(const SimulationResult& result);

} // namespace sparkout
