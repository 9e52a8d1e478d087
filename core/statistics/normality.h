// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/statistics/value_bins.h"

#include <cstdint>
#include <span>

namespace sparkout {

enum class NormalityTest { shapiroWilk, andersonDarling };

/// How normal values are: the probability that normal ones deviate at least so much.
struct Normality {
    NormalityTest test = NormalityTest::shapiroWilk;
    double statistic = 0; ///< W, or A²
    double probability = 1;
};

/// Most values for which the law of Shapiro and Wilk's W is known.
inline constexpr std::size_t mostForShapiroWilk = 5000;

/// Shapiro and Wilk's test of values in rising order, 6 to 5000, that are not all equal
/// [SHAPIRO1965], with Royston's weights and law of W [ROYSTON1995].
[[nodiscard]] Normality shapiroWilk(std::span<const double> sorted);

/// Probability of at least such an A² of so many normal values whose mean and deviation are taken
/// from themselves [DAGOSTINO1986, table 4.9].
[[nodiscard]] double andersonDarlingProbability(double statistic, double count);

/// Anderson and Darling's test of values against the normal law of their own mean and deviation
/// [STEPHENS1974, DAGOSTINO1986], of binned ones: the values of a bin are taken as even within it.
[[nodiscard]] Normality andersonDarling(const ValueBins& bins, double resolution,
                                        std::int64_t count, double mean, double deviation);

} // namespace sparkout
