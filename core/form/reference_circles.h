// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/roundness.h"

#include <optional>
#include <span>

namespace sparkout {

/// Minimum circumscribed circle (MCC) of a section: the smallest circle about all its points, a
/// ring gauge; `reference_mm` is its radius, the roundness deviation the largest distance from it
/// inwards [ISO12181].
///
/// About a trial centre the distances are linear in its shift up to their curvature; that problem,
/// the least r with r ≥ d_k − n_k·shift, is a linear programme in three unknowns, solved exactly by
/// the simplex method on its dual: three points whose directions balance define the circle, and the
/// point with the largest excess replaces one of them. Then the distances are recomputed, until the
/// circle becomes no smaller.
///
/// Empty if no three directions balance, as with a gap of half a turn: the circle is then
/// undefined.
[[nodiscard]] std::optional<RoundnessZone>
minimumCircumscribedCircle(std::span<const double> radii_mm, const Directions& directions);

/// Maximum inscribed circle (MIC): the largest within all the points, a plug gauge; the deviation
/// is the largest distance from it outwards. As above with the greatest r with r ≤ d_k −
/// n_k·shift.
[[nodiscard]] std::optional<RoundnessZone> maximumInscribedCircle(std::span<const double> radii_mm,
                                                                  const Directions& directions);

} // namespace sparkout
