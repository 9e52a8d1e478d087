// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/statistics/value_bins.h"

#include <cstdint>
#include <span>

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

} // namespace sparkout
