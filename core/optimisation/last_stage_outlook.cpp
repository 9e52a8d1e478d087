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
    const auto ended = [&](int made) {
        return stage.sparkOut > 0 ? made >= stage.sparkOut
                                  : gauged.depth_mm >= size_mm && (stage.begun || made > 0);
    };
    const long long mostPasses = maxVisits / run.radii(); // the run itself makes no more
    LastStageOutlook told;
    while (true) {
        told.cutsTooDeep = cuts.isTooDeep(run.diameterDeviation(one.depth_mm, other.depth_mm));
        if (told.cutsTooDeep || ended(told.leastSteps) || told.leastSteps >= stage.mostSteps
            || followed.passes > mostPasses) {
            return told;
        }
        follower->stepAlone(followed, stage.infeed_mm);
        ++told.leastSteps;
    }
}

} // namespace sparkout
