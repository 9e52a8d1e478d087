// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/statistics/value_bins.h"

#include <cstdint>
#include <optional>
#include <span>

/// Confidence intervals of samples. All assume independent draws: for a Latin hypercube or a Sobol
/// sequence they are rather too wide.

namespace sparkout {

enum class NormalityTest { shapiroWilk, andersonDarling };

/// The normality of values: the probability that normal ones deviate at least as much.
struct Normality {
    NormalityTest test = NormalityTest::shapiroWilk;
    double statistic = 0; ///< W, or A²
    double probability = 1;
};

/// Greatest number of values for which the distribution of Shapiro and Wilk's W is known.
inline constexpr std::size_t mostForShapiroWilk = 5000;

/// Shapiro and Wilk's test of values in rising order, 6 to 5000, that are not all equal
/// [SHAPIRO1965], with Royston's weights and law of W [ROYSTON1995].
[[nodiscard]] Normality shapiroWilk(std::span<const double> sorted);

/// Probability of at least such an A² for this number of normal values with estimated mean and
/// deviation [DAGOSTINO1986, table 4.9].
[[nodiscard]] double andersonDarlingProbability(double statistic, double count);

/// Anderson and Darling's test of binned values against the normal distribution with their own mean
/// and deviation [STEPHENS1974, DAGOSTINO1986]: the values are assumed uniform within a bin.
[[nodiscard]] Normality andersonDarling(const ValueBins& bins, double resolution,
                                        std::int64_t count, double mean, double deviation);

/// Of a mean: mean ± t·s/√n, t Student's quantile with n − 1 degrees of freedom; n ≥ 2.
[[nodiscard]] Interval studentInterval(double mean, double deviation, std::int64_t count,
                                       double confidence);

/// Of a share, by Clopper and Pearson, with at least the given confidence for every share:
/// quantiles of Beta(k, n−k+1) and Beta(k+1, n−k) [CLOPPER1934]; n ≥ 1.
[[nodiscard]] Interval clopperPearson(std::int64_t hits, std::int64_t count, double confidence);

/// Ranks r ≤ s, from 1, of the order statistics x_(r) ≤ x_(s) that contain the quantile of order p
/// between them with at least the given confidence, by the binomial distribution with two equal
/// tails; empty if there are too few values.
struct Ranks {
    std::int64_t low = 1, high = 1;
};
[[nodiscard]] std::optional<Ranks> quantileRanks(std::int64_t count, double order,
                                                 double confidence);

/// Of P_p = (U − L)/(6s), and of C_p alike: P_p·√(χ²/(n−1)) [KOTZ1993]; n ≥ 2.
[[nodiscard]] Interval ppInterval(double pp, std::int64_t count, double confidence);

/// Of P_pk, and of C_pk alike, Bissell's approximation: P_pk ± z·√(1/(9n) + P_pk²/(2(n−1)))
/// [BISSELL1990]; n ≥ 2.
[[nodiscard]] Interval ppkInterval(double ppk, std::int64_t count, double confidence);

/// Quantile of the standard normal distribution, 0 < p < 1, and the distribution itself.
[[nodiscard]] double normalQuantile(double p);
[[nodiscard]] double normalShare(double z);

// Comparisons of two samples.

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
