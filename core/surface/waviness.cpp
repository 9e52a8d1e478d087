// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/waviness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sparkout {

Waviness wavinessOf(std::span<const double> radii_mm, const Directions& directions,
                    int leastOrder) {
    const std::vector<Harmonic> all = harmonics(radii_mm, directions);
    const std::size_t K = radii_mm.size();
    const std::size_t below = std::min(static_cast<std::size_t>(leastOrder), all.size());
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t k = 0; k < K; ++k) {
        double wave = radii_mm[k] - all[0].amplitude_mm;
        for (std::size_t n = 1; n < below; ++n) { // cos(nφ_k − phase)
            const std::size_t at = n * k % K;
            wave -= all[n].amplitude_mm
                    * (directions.cosines()[at] * std::cos(all[n].phase_rad)
                       + directions.sines()[at] * std::sin(all[n].phase_rad));
        }
        least = std::min(least, wave); // min and max ignore NaN, as in a gap
        most = std::max(most, wave);
    }
    return {most - least, {all.begin() + static_cast<std::ptrdiff_t>(below), all.end()}};
}

} // namespace sparkout
