// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/last_stage_bound.h"

#include <limits>

namespace sparkout {

namespace {

constexpr double rounding_mm = 1e-9; ///< rounding of lags, generously
constexpr double nearEnough_mm = 1e-6;
constexpr double slopeWidth_mm = 1e-4; ///< interval of the slope
constexpr int mostTries = 50;
constexpr double mostLag_mm = 1e3;

/// A lag before and after a step.
struct LagStep {
    double lag_mm = 0, after_mm = 0;
};

/// Finds a lag near the steady one, from which a step W does not lead to a greater lag; ∞ if none
/// is found.
template <class Next>
LagStep above(double infeed_mm, const Next& next) {
    constexpr double further = 4;
    LagStep at{infeed_mm, next(infeed_mm)};
    while (at.after_mm > at.lag_mm && at.lag_mm < mostLag_mm) {
        at.lag_mm *= further;
        at.after_mm = next(at.lag_mm);
    }
    // Beyond two lags the line through both is above W(w) − w, which is concave.
    for (int i = 0; i < mostTries && at.lag_mm - at.after_mm > nearEnough_mm; ++i) {
        const LagStep then{at.after_mm, next(at.after_mm)};
        const double fall_mm = at.lag_mm - at.after_mm;
        const double nextFall_mm = then.lag_mm - then.after_mm;
        at = then;
        if (nextFall_mm > 0 && nextFall_mm < fall_mm) {
            at.lag_mm -= nextFall_mm * fall_mm / (fall_mm - nextFall_mm);
            at.after_mm = next(at.lag_mm);
        }
    }
    at.lag_mm += rounding_mm;
    at.after_mm = next(at.lag_mm);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return at.after_mm <= at.lag_mm ? at : LagStep{infinity, infinity};
}

/// A lag not above the steady one, and near it.
template <class Next>
double below(double above_mm, const Next& next) {
    for (double less_mm = nearEnough_mm; less_mm < above_mm; less_mm *= 2) {
        const double lag_mm = above_mm - less_mm;
        if (next(lag_mm) >= lag_mm + rounding_mm) {
            return lag_mm;
        }
    }
    return 0; // a radius just reached lags behind the next step
}

} // namespace

const std::vector<double>& SteadyLags::least_mm() {
    for (std::size_t s = m_least_mm.size(); s < m_feeds.size(); ++s) {
        const auto next = [&](double lag_mm) {
            FollowedRadii all;
            all.radii.fill({-lag_mm, 1, m_gauged});
            m_follower.strokesAlone(all, m_feeds[s]);
            return all.fed_mm - all.radii[0].depth_mm;
        };
        m_least_mm.push_back(below(above(m_feeds[s].all_mm, next).lag_mm, next));
    }
    return m_least_mm;
}

const std::vector<SteadyLags::Most>& SteadyLags::most(std::size_t zone) {
    const auto [place, isNew] = m_most.try_emplace(zone);
    for (std::size_t s = 0; isNew && s < m_feeds.size(); ++s) {
        const auto next = [&](double lag_mm) {
            FollowedRadii all;
            all.radii.fill({-lag_mm, 0, zone});
            m_follower.stepAlone(all, m_feeds[s]);
            return all.fed_mm - all.radii[0].depth_mm;
        };
        const LagStep steady = above(m_feeds[s].all_mm, next);
        const double before_mm = next(steady.lag_mm - slopeWidth_mm);
        place->second.push_back({steady.lag_mm, (steady.after_mm - before_mm) / slopeWidth_mm});
    }
    return place->second;
}

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
