// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/form/gaussian_filter.h"

#include "core/form/harmonics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace sparkout {

double gaussianTransmission(double lobes, double cutoff_upr) {
    const double ratio = lobes / cutoff_upr;
    return std::exp(-std::numbers::ln2 * ratio * ratio);
}

// Sums up the removed part, so that the remaining one keeps all its digits.
std::vector<double> gaussianFiltered(std::span<const double> radii, const Directions& directions,
                                     double cutoff_upr) {
    const std::size_t K = radii.size();
    const GroundRadii ground(radii);
    const std::vector<Harmonic> waves = harmonics(radii, directions);
    std::vector<double> filtered(radii.begin(), radii.end());
    if (!ground.areAll()) {
        // Across gaps the profile is not that of the radii: it is built from its waves.
        std::fill(filtered.begin(), filtered.end(), waves.front().amplitude_mm);
    }
    for (std::size_t n = 1; n < waves.size(); ++n) {
        const double passes = gaussianTransmission(static_cast<double>(n), cutoff_upr);
        const double share = ground.areAll() ? passes - 1 : passes;
        const double c = share * waves[n].amplitude_mm * std::cos(waves[n].phase_rad);
        const double s = share * waves[n].amplitude_mm * std::sin(waves[n].phase_rad);
        for (std::size_t k = 0, at = 0; k < K; ++k, at = at + n < K ? at + n : at + n - K) {
            filtered[k] += c * directions.cosines()[at] + s * directions.sines()[at];
        }
    }
    for (std::size_t k = 0; k < K && !ground.areAll(); ++k) {
        filtered[k] = std::isnan(radii[k]) ? radii[k] : filtered[k];
    }
    return filtered;
}

} // namespace sparkout
