// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sparkout {

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

} // namespace sparkout
