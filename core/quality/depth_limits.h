// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"

#include <optional>
#include <vector>

namespace sparkout {

/// The greatest depth of cut that a requirement allows.
struct DepthLimit {
    ConstraintKind kind;
    double depth_mm = 0; ///< 0: not met at any depth
};

/// The limit on a cut.
enum class LimitBound {
    feed,        ///< the machine's greatest infeed, which no cut of uncoupled lanes exceeds
    accuracy,    ///< the last cut that the drawing allows: release
    requirement, ///< a requirement on every pass: burn, self-sharpening, power
    stock,       ///< no limit: all stock left at once
};
/// The key in files: machine_feed, accuracy, stock, or that of the requirement.
[[nodiscard]] const char* limitBoundKey(LimitBound bound, ConstraintKind kind);

/// The greatest infeed of a step [mm] that the machine's range allows, where no cut is greater: for
/// uncoupled places without wheel contact and continuous infeed, a cut satisfies a + γ·P(a) = γ·P(a
/// of the pass before) + Δt, and so a ≤ f from rest on. Empty without a range, or where this is not
/// proved.
[[nodiscard]] std::optional<double> greatestInfeed_mm(const Project& project);

/// For a pass of the effective width b [mm] with this stock left [mm], the greatest depth of cut
/// [mm] by each requirement that is on and limits it, in the order of the kinds; as a feed it is
/// S_lim = a·n [MODEL-8]. Roughness limits the last cut alone. The least of the others is the
/// stepless limit at this stock.
[[nodiscard]] std::vector<DepthLimit> depthLimits(const Project& project, double b, double stock);

/// The limit that binds a cut: the least of those on every cut; null if there is none.
[[nodiscard]] const DepthLimit* bindingOf(const std::vector<DepthLimit>& limits);

/// The requirements that limit the depth of cut: first those on every pass, then those on the last
/// cut alone.
[[nodiscard]] std::vector<ConstraintKind> depthLimitKinds();

/// Whether the wheel dwells on its zone in this step: plunge-in and dwells [MODEL-5].
[[nodiscard]] bool wheelStands(const Place& place);

/// The effective width b of the pass at a place of the cycle [mm]: L_p in plunge; the wheel on the
/// reversal zone in its plunge passes, min(S_ax/n, B) in a stroke [MODEL-5].
[[nodiscard]] double effectiveWidth(const Project& project, const Place& place);

} // namespace sparkout
