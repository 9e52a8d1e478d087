// SPDX-License-Identifier: GPL-3.0-or-later
// Runs with the curves of the limits of their feed.
#pragma once

#include "core/quality/limit_series.h"
#include "tests/core/support/project_fixtures.h"

namespace sparkout::limit_curves {

struct Drawn {
    explicit Drawn(const Project& project)
        : result(simulateUnchecked(project, &trajectory))
        , series(makeLimitSeries(result, trajectory)) {}
    Trajectory trajectory;
    SimulationResult result;
    LimitSeries series;
};

inline double valueAt(const LimitPoints& curve, double stock) {
    const auto after = std::ranges::upper_bound(curve, stock, {}, &LimitPoint::stock_mm);
    if (after == curve.begin() || after == curve.end()) {
        return after == curve.begin() ? curve.front().depth_mm : curve.back().depth_mm;
    }
    const LimitPoint &a = *(after - 1), &b = *after;
    return a.depth_mm
           + (stock - a.stock_mm) / (b.stock_mm - a.stock_mm) * (b.depth_mm - a.depth_mm);
}

} // namespace sparkout::limit_curves
