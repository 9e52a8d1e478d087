// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"

#include <array>
#include <cstddef>

namespace sparkout {

/// A radius that is followed alone.
struct FollowedRadius {
    double depth_mm = 0;
    double share = 0;           ///< of the revolution, at which it is visited
    std::size_t zone = 0;       ///< that it is in
    LaneBalance plunge, stroke; ///< its balance in plunging and dwelling, and in strokes
};

/// A few radii and how far the wheel is fed at them.
struct FollowedRadii {
    static constexpr std::size_t count = 3;
    double fed_mm = 0;    ///< t_П
    long long passes = 0; ///< made so far, each of one zone at least
    std::array<FollowedRadius, count> radii;
};

/// Follows a few radii through steps of a cycle without the rest of the part: each is cut as the
/// whole run would cut it, but for rounding. Where radii depend on each other there is none.
class RadiusFollower {
public:
    virtual ~RadiusFollower() = default;
    /// From the state of the run on, at an axial feed [mm/min]; lanes as the run numbers them.
    [[nodiscard]] virtual FollowedRadii
    follow(const std::array<std::size_t, FollowedRadii::count>& lanes,
           double axialFeed_mm_min) const = 0;
    /// One step with this infeed [mm].
    virtual void stepAlone(FollowedRadii& radii, double infeed_mm) const = 0;
};

} // namespace sparkout
