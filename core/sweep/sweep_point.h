// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_run.h"

namespace sparkout {

/// A point with its quantities, before those of all points are set side by side.
struct MeasuredPoint {
    SweepPoint point;
    std::vector<SweepQuantity> quantities;
};

/// Everything a sweep reports of one run.
[[nodiscard]] MeasuredPoint measurePoint(const SimulationResult& result);

} // namespace sparkout
