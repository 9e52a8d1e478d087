// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/roundness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace sparkout {

// Loops over the points of a section, only for the sources that are compiled with the options of
// inner loops.

struct ValueRange {
    double low = 0, high = 0;
};

/// Smallest and largest of the values, none of them NaN, in one vectorised pass.
inline ValueRange rangeOf(std::span<const double> values) {
    const double* __restrict v = values.data();
    const std::size_t count = values.size();
    double low = v[0], high = v[0];
#pragma omp simd reduction(min : low) reduction(max : high)
    for (std::size_t i = 0; i < count; ++i) {
        low = v[i] < low ? v[i] : low;
        high = v[i] > high ? v[i] : high;
    }
    return {low, high};
}

/// The points of a section as seen from a centre: distance and direction.
struct CentreView {
    explicit CentreView(std::size_t K) : d(K), nx(K), ny(K) {}

    void take(std::span<const double> radii, const Directions& directions, double x, double y) {
        const double* __restrict R = radii.data();
        const double* __restrict c = directions.cosines().data();
        const double* __restrict s = directions.sines().data();
        double* __restrict distance = d.data();
        double* __restrict nxk = nx.data();
        double* __restrict nyk = ny.data();
        const std::size_t K = radii.size();
#pragma omp simd
        for (std::size_t k = 0; k < K; ++k) {
            const double px = R[k] * c[k] - x, py = R[k] * s[k] - y;
            const double dk = std::sqrt(px * px + py * py);
            const double inverse = 1 / dk;
            distance[k] = dk;
            nxk[k] = px * inverse;
            nyk[k] = py * inverse;
        }
    }
    void takeLimacon(std::span<const double> radii, const Directions& directions) {
        std::copy(radii.begin(), radii.end(), d.begin());
        std::copy(directions.cosines().begin(), directions.cosines().end(), nx.begin());
        std::copy(directions.sines().begin(), directions.sines().end(), ny.begin());
    }

    std::vector<double> d, nx, ny;
};

} // namespace sparkout
