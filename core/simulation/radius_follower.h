// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"

#include <array>
#include <cstddef>

namespace sparkout {

class Run;
struct StepFeed;

/// A radius that is followed alone.
struct FollowedRadius {
    double depth_mm = 0;
    double share = 0;     ///< of the revolution, at which it is visited
    std::size_t zone = 0; ///< or section that it is in
};

/// A few radii and how far the wheel is fed at them.
struct FollowedRadii {
    static constexpr std::size_t count = 3;
    using Lanes = std::array<std::size_t, count>; ///< as the run numbers them
    double fed_mm = 0;                            ///< t_П
    long long passes = 0;                         ///< followed so far, each of one zone at least
    std::array<FollowedRadius, count> radii;
};

/// What a step feeds, and how the zones yield in its strokes.
struct FollowedFeed {
    double infeed_mm = 0; ///< at the reversals, or in a revolution
    double all_mm = 0;    ///< with the continuous infeed, if it has one
    double continuousFeed_mm_min = 0, axialFeed_mm_min = 0; ///< traverse
    std::array<LaneBalance, 3> strokes;                     ///< by zone; traverse
};

/// Follows a few radii through steps of a cycle without the rest of the part: each is cut as the
/// whole run would cut it, but for rounding. Where radii depend on each other there is none. Feeds
/// and steps are the same for all states of a part. In plunge grinding a step is one stroke.
class RadiusFollower {
public:
    virtual ~RadiusFollower() = default;
    /// Radii as they stand now.
    [[nodiscard]] virtual FollowedRadii follow(const FollowedRadii::Lanes& lanes) const = 0;
    /// Of a step that is not cut short.
    [[nodiscard]] virtual FollowedFeed feed(const StepFeed& step) const = 0;
    virtual void stepAlone(FollowedRadii& radii, const FollowedFeed& feed) const = 0;
    /// Of a step the strokes alone, which cut all zones. A radius that no other pass cuts stands as
    /// after the step, any other one no deeper.
    virtual void strokesAlone(FollowedRadii& radii, const FollowedFeed& feed) const = 0;
    /// Whether no other pass cuts any radius.
    [[nodiscard]] virtual bool hasStrokesAlone() const = 0;
};

/// Radii of a run as they stand now.
[[nodiscard]] FollowedRadii radiiOf(const Run& run, const FollowedRadii::Lanes& lanes);

/// A pass at a radius that the wheel is fed to t_П = `fed_mm` at.
inline void cutAlone(FollowedRadius& radius, const LaneBalance& balance, double fed_mm) {
    const double root = balance.root(fed_mm - radius.depth_mm);
    radius.depth_mm += root * root;
}

} // namespace sparkout
