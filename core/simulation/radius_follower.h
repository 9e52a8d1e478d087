// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"

#include <array>
#include <cstddef>

namespace sparkout {

class Run;
struct StepFeed;

/// A radius that is followed without the rest of the part.
struct FollowedRadius {
    double depth_mm = 0;
    double share = 0;     ///< share of the revolution at which it is visited
    std::size_t zone = 0; ///< its zone or section
};

/// A few radii and the total infeed at them.
struct FollowedRadii {
    static constexpr std::size_t count = 3;
    using Lanes = std::array<std::size_t, count>; ///< lane numbers of the run
    double fed_mm = 0;                            ///< t_П
    long long passes = 0; ///< passes followed so far, each over at least one zone
    std::array<FollowedRadius, count> radii;
};

/// Feed of a step, and the balances of the zones in its strokes.
struct FollowedFeed {
    double infeed_mm = 0; ///< at the reversals, or in a revolution
    double all_mm = 0;    ///< total, with any continuous infeed
    double continuousFeed_mm_min = 0, axialFeed_mm_min = 0; ///< traverse
    std::array<LaneBalance, 3> strokes;                     ///< by zone; traverse
};

/// Follows a few radii through steps of a cycle without the rest of the part: each is cut as in the
/// whole run, except for rounding. Where radii depend on each other there is no follower. Feeds and
/// steps are the same for all states of a part. In plunge grinding a step is one stroke.
class RadiusFollower {
public:
    virtual ~RadiusFollower() = default;
    /// The radii in their current state.
    [[nodiscard]] virtual FollowedRadii follow(const FollowedRadii::Lanes& lanes) const = 0;
    /// Returns the feed of a full step.
    [[nodiscard]] virtual FollowedFeed feed(const StepFeed& step) const = 0;
    virtual void stepAlone(FollowedRadii& radii, const FollowedFeed& feed) const = 0;
    /// Makes only the strokes of a step, which cut all zones. A radius that no other pass cuts is
    /// then in its final state, any other one is no deeper.
    virtual void strokesAlone(FollowedRadii& radii, const FollowedFeed& feed) const = 0;
    /// Returns whether strokes are the only passes that cut.
    [[nodiscard]] virtual bool hasStrokesAlone() const = 0;
};

/// Returns the current radii of a run.
[[nodiscard]] FollowedRadii radiiOf(const Run& run, const FollowedRadii::Lanes& lanes);

/// Cuts a radius by one pass with the wheel fed to t_П = `fed_mm`.
inline void cutAlone(FollowedRadius& radius, const LaneBalance& balance, double fed_mm) {
    const double root = balance.root(fed_mm - radius.depth_mm);
    radius.depth_mm += root * root;
}

} // namespace sparkout
