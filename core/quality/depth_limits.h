// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"

#include <vector>

namespace sparkout {

/// The greatest depth of cut that a requirement allows.
struct DepthLimit {
    ConstraintKind kind;
    double depth_mm = 0; ///< 0: not met at any depth
};

/// For a pass of the effective width b [mm] with this stock left [mm], the greatest depth of cut
/// [mm] of every requirement that is on and limits it, in the order of the kinds; as a feed it is
/// S_lim = a·n [MODEL-8]. Roughness limits the last cut alone. The least of them is the stepless
/// limit at this stock.
[[nodiscard]] std::vector<DepthLimit> depthLimits(const Project& project, double b, double stock);

/// The limit that binds a cut: the least of those that bind every one; null: there is none.
[[nodiscard]] const DepthLimit* bindingOf(const std::vector<DepthLimit>& limits);

/// The requirements that limit the depth of cut: of every pass, then those of the last cut alone.
[[nodiscard]] std::vector<ConstraintKind> depthLimitKinds();

/// Whether the wheel stands on its zone in this step: plunge-in and dwells [MODEL-5].
[[nodiscard]] bool wheelStands(const Place& place);

/// The effective width b of the pass at a place of the cycle [mm]: L_p in plunge; the wheel on the
/// reversal zone in its plunge passes, min(S_ax/n, B) in a stroke [MODEL-5].
[[nodiscard]] double effectiveWidth(const Project& project, const Place& place);

} // namespace sparkout
