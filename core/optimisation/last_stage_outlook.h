// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/pass_cuts.h"
#include "core/simulation/cycle_steps.h"

#include <limits>

namespace sparkout {

/// How the last stage of a cycle is tried on a few radii before it is run.
struct LastStage {
    FollowedFeed feed; ///< of a step
    int sparkOut = 0;  ///< > 0: it ends after so many steps
    bool begun = true; ///< steps were made before it
    int mostSteps = std::numeric_limits<int>::max();
};

/// The radii that a last stage is judged by: one as deep as the deepest of the gauge's place that
/// is visited at the end of the revolution, and the two opposite ones that are the deepest
/// together. Of a state with a follower.
[[nodiscard]] FollowedRadii tellingRadii(const CycleSteps& steps);

/// What is proved of a last stage by three of the part's radii.
struct LastStageOutlook {
    int leastSteps = 0;       ///< it does not end before
    bool cutsTooDeep = false; ///< a diameter ends beyond the field
};

/// Under gauge control, from a state on in which all feeding stages but the last are done. Levels
/// of feeds are above 0: nothing retracts.
///
/// The gauge stands in НЗ, or in a section, which is cut in strokes alone. The cycle ends when
/// Π_rem ≤ slack, and Π_rem is |R_first − R_t| less the mean depth of two opposite radii there, or
/// of all of them: not before the deepest of these radii is at the size. They have one γ, and depth
/// + a(t_П − depth) rises with t_П and with depth, as a rises by no more than its infeed does: so
/// none comes to be deeper than one that is as deep as the deepest now and is visited at the end of
/// the revolution, where the most is fed, and that one alone gives a number of steps before which
/// the stage does not end. Radii only grow deeper: a diameter of two others beyond the field after
/// that many steps is beyond it at the end. Taken are the two that are the deepest now. For the
/// same reason the strokes alone make none deeper than all passes do: mostly they show already that
/// it is too deep, and only where they do not are the other passes followed. Where radii depend on
/// each other, or the gauge stands elsewhere, nothing is known.
///
/// @param part  any steps of the part, with a follower
[[nodiscard]] LastStageOutlook outlook(const CycleSteps& part, const FollowedRadii& telling,
                                       const LastStage& stage, const PassCuts& cuts);

} // namespace sparkout
