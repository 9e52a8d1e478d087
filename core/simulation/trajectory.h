// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace sparkout {

/// One revolution or stroke of one zone or section: K visits, one a radius.
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
    double radius_mm = 0;      ///< R_k of the part after the pass; not a number in a gap
    double normalForce_n = 0;  ///< P_y(a)
    double printed_mm = 0;     ///< c(φ_k): in the machine's frame so much more stock is left

    /// Whether the wheel passed a gap: nothing was there.
    [[nodiscard]] bool isGap() const { return std::isnan(radius_mm) && actual_mm == 0; }
};

/// Runs beyond this many visits are not recorded: 56 bytes each, and as a trace 130 more.
inline constexpr long long maxRecordedVisits = 2'000'000;

/// Everything that happened, pass by pass; recorded only when asked for.
struct Trajectory {
    int radii = 0; ///< K
    std::vector<Pass> passes;
    std::vector<Visit> visits; ///< size passes · K
};

} // namespace sparkout
