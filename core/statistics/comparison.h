// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/statistics/intervals.h"

#include <cstdint>

/// Comparisons of two samples.
namespace sparkout {

/// Quantile of Student's law, 0 < p < 1, freedom > 0.
[[nodiscard]] double studentQuantile(double p, double freedom);

/// Quantile of Fisher's distribution of the ratio of two variances with these degrees of freedom.
[[nodiscard]] double fisherQuantile(double p, double freedom, double otherFreedom);

/// Fisher's test of two variances of normal values [FISHER1925]: whether their ratio can be chance.
struct VarianceRatio {
    double ratio = 1; ///< s₁²/s₂²
    std::int64_t freedom = 1, otherFreedom = 1;
    double low = 0, high = 0; ///< bounds of the ratio by chance at this confidence
    double probability = 1;   ///< probability of a ratio at least as far from 1, on either side
    [[nodiscard]] bool differs() const { return ratio < low || ratio > high; }
};
/// For standard deviations of n ≥ 2 values each, the other not 0.
[[nodiscard]] VarianceRatio varianceRatio(double deviation, std::int64_t count, double other,
                                          std::int64_t otherCount, double confidence);

/// For the difference of two means, mean − other, with any variances [WELCH1947]; each n ≥ 2 and
/// one deviation not 0.
struct SampleMean {
    double mean = 0, deviation = 0;
    std::int64_t count = 0;
};
[[nodiscard]] Interval welchInterval(const SampleMean& one, const SampleMean& other,
                                     double confidence);

} // namespace sparkout
