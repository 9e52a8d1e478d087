// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/pass_cuts.h"
#include "core/simulation/cycle_steps.h"

#include <limits>

namespace sparkout {

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
