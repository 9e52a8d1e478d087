// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/last_stage_outlook.h"

namespace sparkout {

namespace {
constexpr double followedRounding_mm = 1e-9; ///< of depths, generously
}

FollowedRadii tellingRadii(const CycleSteps& steps) {
    const auto [lane, opposite] = steps.run().deepestDiameter();
    FollowedRadii telling =
        steps.follower()->follow({steps.run().deepestLane(steps.gaugePoint()), lane, opposite});
    telling.radii[0].share = 1;
    return telling;
}

LastStageOutlook outlook(const CycleSteps& part, const FollowedRadii& telling,
                         const LastStage& stage, const PassCuts& cuts) {
    const RadiusFollower& follower = *part.follower();
    const Run& run = part.run();
    const double size_mm = run.sizeDepth_mm() - stageSlack_mm - followedRounding_mm;
    const auto isTooDeep = [&](const FollowedRadii& at) {
        return cuts.isTooDeep(run.diameterDeviation(at.radii[1].depth_mm, at.radii[2].depth_mm));
    };
    LastStageOutlook outlook;
    FollowedRadii strokes = telling;
    const auto ended = [&] {
        return stage.sparkOut > 0 ? outlook.leastSteps >= stage.sparkOut
                                  : strokes.radii[0].depth_mm >= size_mm
                                        && (stage.begun || outlook.leastSteps > 0);
    };
    const long long mostPasses = maxVisits / run.radii(); // the run itself makes no more
    while (!(outlook.cutsTooDeep = isTooDeep(strokes)) && !ended()) {
        if (outlook.leastSteps >= stage.mostSteps || strokes.passes > mostPasses) {
            return outlook;
        }
        follower.strokesAlone(strokes, stage.feed);
        ++outlook.leastSteps;
    }
    if (outlook.cutsTooDeep || follower.hasStrokesAlone()) {
        return outlook;
    }
    FollowedRadii all = telling;
    for (int made = 0; made < outlook.leastSteps && !outlook.cutsTooDeep; ++made) {
        follower.stepAlone(all, stage.feed);
        outlook.cutsTooDeep = isTooDeep(all);
    }
    return outlook;
}

} // namespace sparkout
