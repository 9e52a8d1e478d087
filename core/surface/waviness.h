// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/harmonics.h"

#include <span>
#include <vector>

namespace sparkout {

/// The waves of a closed profile, without the orders below the least one, which are its mean, its
/// eccentricity and its lobes.
struct Waviness {
    double height_mm = 0;         ///< from peak to valley
    std::vector<Harmonic> orders; ///< from the least order on
};

/// Radii that are no number, in gaps, have no peak and no valley.
[[nodiscard]] Waviness wavinessOf(std::span<const double> radii_mm, const Directions& directions,
                                  int leastOrder);

} // namespace sparkout
