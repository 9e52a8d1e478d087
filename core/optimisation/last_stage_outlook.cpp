// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/last_stage_outlook.h"

namespace sparkout {

namespace {
constexpr double followedRounding_mm = 1e-9; ///< of depths, generously
}

LastStageOutlook outlook(const CycleSteps& steps, const LastStage& stage, const PassCuts& cuts) {
    const RadiusFollower* follower = steps.follower();
    if (!follower) {
        return {};
    }
    const Run& run = steps.run();
    const auto [lane, opposite] = run.deepestDiameter();
    FollowedRadii followed = follower->follow({run.deepestLane(steps.gaugePoint()), lane, opposite},
                                              stage.axialFeed_mm_min);
    const auto& [gauged, one, other] = followed.radii;
    const double size_mm = run.blank().totalInfeed_mm - stageSlack_mm - followedRounding_mm;
    LastStageOutlook told;
    while (told.leastSteps < stage.mostSteps
           && (stage.sparkOut > 0
                   ? told.leastSteps < stage.sparkOut
                   : gauged.depth_mm < size_mm || (!stage.begun && told.leastSteps == 0))) {
        follower->stepAlone(followed, stage.infeed_mm);
        ++told.leastSteps;
    }
    told.cutsTooDeep = cuts.isTooDeep(run.diameterDeviation(one.depth_mm, other.depth_mm));
    return told;
}

} // namespace sparkout
