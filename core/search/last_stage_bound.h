// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/cycle_runner.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/radius_follower.h"

#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace sparkout {

/// Lags of radii behind the wheel when steps of one setting are repeated.
///
/// The lag of a radius after a step is w = t_П − depth, the infeed that is not cut. The next step
/// changes it to W(w). A pass leaves h − a(h) of the lag h before it, and a rises by no more than h
/// does, and ever faster (a = 0 up to h = 0): so W rises and is concave, and W(w) > w for a radius
/// that is not reached yet. Hence, where W(ŵ) ≥ ŵ, no lag falls below the lesser of itself and ŵ;
/// where W(ŵ) ≤ ŵ, none rises beyond the greater, and a lag beyond ŵ approaches it in n steps with
/// the slope ρ of W there: w_n ≤ ŵ + ρⁿ·(w_0 − ŵ). Both ŵ are sought next to the steady lag, where
/// W(w) = w.
class SteadyLags {
public:
    struct Most {
        double lag_mm = 0; ///< ŵ with W(ŵ) ≤ ŵ
        double slope = 0;  ///< ρ: not below the slope of W at ŵ and beyond
    };

    /// Takes a follower, its feeds by setting, and the gauged zone or section.
    SteadyLags(const RadiusFollower& follower, const std::vector<FollowedFeed>& feeds,
               std::size_t gauged)
        : m_follower(follower), m_feeds(feeds), m_gauged(gauged) {}

    /// Returns, by setting, ŵ with W(ŵ) ≥ ŵ [mm] for a gauged radius at the end of the revolution,
    /// where only the strokes cut.
    [[nodiscard]] const std::vector<double>& least_mm();
    /// Returns the upper bounds of the lags of all radii of a zone or section, by setting.
    [[nodiscard]] const std::vector<Most>& most(std::size_t zone);

private:
    const RadiusFollower& m_follower;
    const std::vector<FollowedFeed>& m_feeds;
    std::size_t m_gauged;
    std::vector<double> m_least_mm;                  ///< empty: not computed yet
    std::map<std::size_t, std::vector<Most>> m_most; ///< by zone
};

/// Last stage of a cycle that is followed on a few radii before it is run.
struct LastStage {
    FollowedFeed feed; ///< feed of a step
    int sparkOut = 0;  ///< > 0: the stage ends after this number of steps
    bool begun = true; ///< the cycle has steps before it
    int mostSteps = std::numeric_limits<int>::max();
};

/// Returns the critical radii of a state with a follower, by which a last stage is bounded: one as
/// deep as the deepest at the gauge that is visited at the end of the revolution, and the two
/// opposite ones that are the deepest together.
[[nodiscard]] FollowedRadii criticalRadii(const CycleSteps& steps);

/// Bound of a last stage that three of the part's radii prove.
struct LastStageBound {
    int leastSteps = 0;       ///< least number of steps of the stage
    bool cutsTooDeep = false; ///< a diameter ends below the tolerance field (bore: above it)
};

/// Bounds the last stage under gauge control from a state in which all feeding stages but the last
/// are done. Feeds of the grid are above 0: no stage retracts.
///
/// The gauge is in НЗ, or in a section, which is cut in strokes alone. The cycle ends when Π_rem ≤
/// slack, and Π_rem is |R_first − R_t| less the mean depth of two opposite radii there, or of all
/// of them: not before the deepest of these radii is at the size. They have one γ, and depth +
/// a(t_П − depth) rises with t_П and with depth, as a rises by no more than its infeed does: so
/// none becomes deeper than one that is now as deep as the deepest and is visited at the end of the
/// revolution, where the infeed is greatest; that one alone gives a number of steps before which
/// the stage does not end. Radii only grow deeper: a diameter of two others beyond the field after
/// that many steps is beyond it at the end. The two that are deepest now are taken. For the same
/// reason the strokes alone make no radius deeper than all passes do: mostly they already show that
/// a diameter is too deep, and the other passes are followed only where they do not. Where radii
/// depend on each other, or the gauge is elsewhere, there is no bound.
///
/// @param part  any steps of the part, with a follower
[[nodiscard]] LastStageBound lastStageBound(const CycleSteps& part, const FollowedRadii& critical,
                                            const LastStage& stage, const PassCuts& cuts);

} // namespace sparkout
