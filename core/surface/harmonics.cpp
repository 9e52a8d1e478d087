// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/harmonics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace sparkout {

namespace {

/// Bridges the gaps, whose radii are NaN, by straight lines.
std::vector<double> bridged(std::span<const double> given) {
    std::vector<double> radii(given.begin(), given.end());
    const std::size_t K = radii.size();
    const GroundRadii ground(given);
    const std::vector<std::size_t>& at = ground.indices();
    for (std::size_t i = 0; i < at.size() && !ground.areAll(); ++i) {
        const std::size_t from = at[i], to = at[(i + 1) % at.size()];
        const std::size_t apart = (to + K - from - 1) % K + 1;
        for (std::size_t step = 1; step < apart; ++step) {
            const double share = static_cast<double>(step) / static_cast<double>(apart);
            radii[(from + step) % K] = given[from] + share * (given[to] - given[from]);
        }
    }
    return radii;
}

} // namespace

// cos(n·φ_k) is the direction n·k mod K; the mean is subtracted first, so that small lobes on a
// large radius keep their digits.
std::vector<Harmonic> harmonics(std::span<const double> given, const Directions& directions) {
    const std::vector<double> radii = bridged(given);
    const std::size_t K = radii.size();
    const auto count = static_cast<double>(K);
    const std::vector<double>& cosines = directions.cosines();
    const std::vector<double>& sines = directions.sines();
    double mean = radii[0];
    for (const double R : radii) {
        mean += (R - radii[0]) / count;
    }
    std::vector<Harmonic> found{{0, mean, 0}};
    for (std::size_t n = 1; n <= K / 2; ++n) {
        double c = 0, s = 0;
        for (std::size_t k = 0, at = 0; k < K; ++k, at = at + n < K ? at + n : at + n - K) {
            c += (radii[k] - mean) * cosines[at];
            s += (radii[k] - mean) * sines[at];
        }
        const bool half = 2 * n == K;
        const double share = (half ? 1 : 2) / count;
        if (half) {
            s = 0; // sin(K/2·φ_k) is 0 at every sample
        }
        found.push_back({static_cast<int>(n), share * std::hypot(c, s), std::atan2(s, c)});
    }
    return found;
}

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
