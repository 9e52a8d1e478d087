// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/radius_follower.h"

#include "core/simulation/run.h"

namespace sparkout {

FollowedRadii radiiOf(const Run& run, const FollowedRadii::Lanes& lanes) {
    FollowedRadii radii{.fed_mm = run.fed_mm, .radii = {}};
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        radii.radii[i] = {run.depth_mm(lanes[i]), run.share(lanes[i]), run.pointOf(lanes[i])};
    }
    return radii;
}

} // namespace sparkout
