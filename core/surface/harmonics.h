// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/roundness.h"

#include <span>
#include <vector>

namespace sparkout {

/// One harmonic of a profile: amplitude·cos(lobes·φ − phase).
struct Harmonic {
    int lobes = 0;
    double amplitude_mm = 0; ///< ≥ 0; of lobe number 0 the mean radius
    double phase_rad = 0;    ///< −π…π; a crest is at φ = phase/lobes
};

/// The discrete Fourier sum of a section's K radii, lobe numbers 0 to ⌊K/2⌋:
///
///     R_k = Σ amplitude_n·cos(n·φ_k − phase_n)      exactly, for every k
///
/// Lobe number 1 is the eccentricity. Of lobe number K/2 the samples see the cosine only.
/// Parseval: (1/K)·ΣR_k² = A_0² + ½·ΣA_n² + A_(K/2)².
/// Radii that are no number, in gaps, are bridged by straight lines.
[[nodiscard]] std::vector<Harmonic> harmonics(std::span<const double> radii_mm,
                                              const Directions& directions);

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
