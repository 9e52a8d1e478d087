// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/roundness.h"

#include <span>
#include <vector>

namespace sparkout {

/// Share of a wave's amplitude that the Gaussian filter for closed profiles transmits, half at the
/// cut-off n_c [undulations per revolution] [ISO16610-21]:
///
///     a_1/a_0 = exp( −ln 2·(n/n_c)² )
[[nodiscard]] double gaussianTransmission(double lobes, double cutoff_upr);

/// A section's K radii after that low-pass filter: the convolution of the closed profile that the
/// radii are samples of with the Gaussian weighting function, which multiplies each harmonic by its
/// transmission. Exact for profiles without waves above K/2. Radii in gaps remain NaN; the filter
/// uses straight lines across them.
[[nodiscard]] std::vector<double> gaussianFiltered(std::span<const double> radii_mm,
                                                   const Directions& directions, double cutoff_upr);

} // namespace sparkout
