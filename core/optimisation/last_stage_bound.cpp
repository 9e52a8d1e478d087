// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/last_stage_bound.h"

namespace sparkout {

namespace {
constexpr double followedRounding_mm = 1e-9; ///< rounding of depths, generously
}

FollowedRadii criticalRadii(const CycleSteps& steps) {
    const auto [lane, opposite] = steps.run().deepestDiameter();
    FollowedRadii critical =
        steps.follower()->follow({steps.run().deepestLane(steps.gaugePoint()), lane, opposite});
    critical.radii[0].share = 1;
    return critical;
}

LastStageBound lastStageBound(const CycleSteps& part, const FollowedRadii& critical,
                              const LastStage& stage, const PassCuts& cuts) {
    const RadiusFollower& follower = *part.follower();
    const Run& run = part.run();
    const double size_mm = run.sizeDepth_mm() - stageSlack_mm - followedRounding_mm;
    const auto isTooDeep = [&](const FollowedRadii& at) {
        return cuts.isTooDeep(run.diameterDeviation(at.radii[1].depth_mm, at.radii[2].depth_mm));
    };
    LastStageBound bound;
    FollowedRadii strokes = critical;
    const auto ended = [&] {
        return stage.sparkOut > 0
                   ? bound.leastSteps >= stage.sparkOut
                   : strokes.radii[0].depth_mm >= size_mm && (stage.begun || bound.leastSteps > 0);
    };
    const long long mostPasses = maxVisits / run.radii(); // the run itself makes no more
    while (!(bound.cutsTooDeep = isTooDeep(strokes)) && !ended()) {
        if (bound.leastSteps >= stage.mostSteps || strokes.passes > mostPasses) {
            return bound;
        }
        follower.strokesAlone(strokes, stage.feed);
        ++bound.leastSteps;
    }
    if (bound.cutsTooDeep || follower.hasStrokesAlone()) {
        return bound;
    }
    FollowedRadii all = critical;
    for (int made = 0; made < bound.leastSteps && !bound.cutsTooDeep; ++made) {
        follower.stepAlone(all, stage.feed);
        bound.cutsTooDeep = isTooDeep(all);
    }
    return bound;
}

} // namespace sparkout
