// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/characteristics.h"
#include "core/statistics/exact_sum.h"
#include "core/statistics/value_bins.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace sparkout {

/// A value and its part; of equal values the part with the lower number.
struct PartValue {
    double value = 0;
    std::int64_t part = -1; ///< −1: none
};

/// Σ s_i·s_j of the factors' rank scores, i ≤ j, row by row: whole numbers, exact.
using ScoreProducts = std::array<std::int64_t, factorKinds*(factorKinds + 1) / 2>;
/// The index of the product of the scores of two factors, i ≤ j.
[[nodiscard]] constexpr std::size_t productPlace(std::size_t i, std::size_t j) {
    return i * (2 * factorKinds - i - 1) / 2 + j;
}

/// The statistics of one characteristic over the parts: exact sums, counts and extremes. Its size
/// does not grow with the number of parts, and joining two of them is exact, in any order.
struct ValueStatistics {
    std::int64_t count = 0;
    std::array<ExactSum, 4> powers; ///< Σx, Σx², Σx³, Σx⁴, each power rounded before it is summed
    PartValue least, most;
    std::int64_t below = 0, above = 0; ///< parts outside the limits
    ValueBins bins;
    ScoreProducts products{}; ///< over the parts that have a value

    /// Adds a value of a part whose factors have these ranks; keeps at most `mostBins` bins.
    void add(double value, std::int64_t part, const Characteristic& characteristic,
             const RankScores& scores, std::size_t mostBins);
    void add(const ValueStatistics& other, std::size_t mostBins);
};

struct PartRow {
    std::int64_t part = 0;
    std::vector<double> values;
};

struct BatchStatistics {
    static constexpr std::int64_t keptRows = 4096; ///< lower part numbers are kept individually

    std::int64_t parts = 0;
    std::int64_t failed = 0; ///< parts that did not reach size: no values
    std::int64_t bad = 0;    ///< failed parts and parts that miss a requirement
    /// Parts that miss a requirement of each kind; a part that misses several counts for each.
    std::array<std::int64_t, constraintKinds> rejects{};
    PartValue worst; ///< least relative margin; a failed part has the lowest number
    std::vector<ValueStatistics> values; ///< by characteristic
    std::vector<PartRow> rows; ///< rows of the parts below keptRows, unordered until sorted

    void add(const PartOutcome& outcome, std::int64_t part,
             const std::vector<Characteristic>& characteristics, const RankScores& scores);
    void add(const BatchStatistics& other);
    /// Whether every part with values is among the rows.
    [[nodiscard]] bool keepsAll() const;
    /// Sorts the rows, so that equal parts give equal statistics.
    void sort();
};

[[nodiscard]] bool operator==(const PartValue& a, const PartValue& b);
[[nodiscard]] bool operator==(const ValueStatistics& a, const ValueStatistics& b);
/// Compares bit for bit, with rows in the same order.
[[nodiscard]] bool operator==(const BatchStatistics& a, const BatchStatistics& b);

inline constexpr double confidence95 = 0.95;

/// Mean, standard deviation and shape of the values.
struct Moments {
    double mean = 0;
    double deviation = 0; ///< s, with n − 1; 0 of one value
    double skewness = 0;  ///< g₁ = m₃/m₂^1.5; NaN where its error may exceed 0.001
    double excess = 0;    ///< g₂ = m₄/m₂² − 3; NaN if not computable
};
[[nodiscard]] Moments momentsOf(const ValueStatistics& values);

} // namespace sparkout
