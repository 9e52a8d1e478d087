// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace sparkout {

/// One revolution or stroke over one zone or section, with K visits, one for each radius.
struct Pass {
    Place place;
    double start_s = 0;           ///< time at which the pass begins
    double duration_s = 0;        ///< time of the pass
    double effectiveWidth_mm = 0; ///< b of the force law
    double axialFeed_mm_min = 0;  ///< S_ax of a traverse pass, 0 in plunge passes
    double radialFeed_mm = 0;     ///< programmed feed of the double stroke or revolution
    std::size_t firstVisit = 0;   ///< index of radius 0 in the visits; K follow
};

/// One radius under the wheel once.
struct Visit {
    double time_s = 0;
    double programmed_mm = 0;  ///< t_П at this radius, total
    double actual_mm = 0;      ///< a, depth of cut
    double accumulated_mm = 0; ///< Σa of this radius
    double radius_mm = 0;      ///< R_k of the part after the pass; NaN in a gap
    double normalForce_n = 0;  ///< P_y(a)
    double printed_mm = 0;     ///< c(φ_k): additional remaining stock in the machine's frame

    /// Returns whether the wheel passed a gap.
    [[nodiscard]] bool isGap() const { return std::isnan(radius_mm) && actual_mm == 0; }
};

/// Greatest number of visits that is recorded: each takes 56 bytes, and 130 more as a trace.
inline constexpr long long maxRecordedVisits = 2'000'000;

/// All passes and visits of a run; recorded only on request.
struct Trajectory {
    int radii = 0; ///< K
    std::vector<Pass> passes;
    std::vector<Visit> visits; ///< size passes · K
};

} // namespace sparkout
