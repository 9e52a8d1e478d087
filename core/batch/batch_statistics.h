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

/// A value with the part that has it; of equals the part of the lower number.
struct PartValue {
    double value = 0;
    std::int64_t part = -1; ///< −1: none yet
};

/// Σ s_i·s_j of the factors' rank scores, i ≤ j, row by row: whole numbers, exact.
using ScoreProducts = std::array<std::int64_t, factorKinds*(factorKinds + 1) / 2>;
/// Where the product of the scores of two factors stands, i ≤ j.
[[nodiscard]] constexpr std::size_t productPlace(std::size_t i, std::size_t j) {
    return i * (2 * factorKinds - i - 1) / 2 + j;
}

/// What is kept of one characteristic over the parts: exact sums, counts and extremes. Its size
/// does not grow with the number of parts, and joining two of them is exact, in any order.
struct ValueStatistics {
    std::int64_t count = 0;
    std::array<ExactSum, 4> powers; ///< Σx, Σx², Σx³, Σx⁴, each power rounded before it is summed
    PartValue least, most;
    std::int64_t below = 0, above = 0; ///< out of the limits
    ValueBins bins;
    ScoreProducts products{}; ///< of the parts that have a value

    /// A value of a part whose factors have these ranks; at most `mostBins` bins are kept.
    void add(double value, std::int64_t part, const Characteristic& characteristic,
             const RankScores& scores, std::size_t mostBins);
    void add(const ValueStatistics& other, std::size_t mostBins);
};

/// The values of one part.
struct PartRow {
    std::int64_t part = 0;
    std::vector<double> values;
};

/// What is kept of the parts of a batch.
struct BatchStatistics {
    static constexpr std::int64_t keptRows = 4096; ///< parts of lower number are kept one by one

    std::int64_t parts = 0;
    std::int64_t failed = 0; ///< whose cycle did not reach size: no values
    std::int64_t bad = 0;    ///< these, and those a requirement fails
    /// Parts that fail a requirement of each kind; one that fails several counts at each of them.
    std::array<std::int64_t, constraintKinds> rejects{};
    PartValue worst; ///< least relative margin; a failed part has the lowest number there is
    std::vector<ValueStatistics> values; ///< by characteristic
    std::vector<PartRow> rows;           ///< of the parts below keptRows, in any order until sorted

    void add(const PartOutcome& outcome, std::int64_t part,
             const std::vector<Characteristic>& characteristics, const RankScores& scores);
    void add(const BatchStatistics& other);
    /// Whether every part with values is among the rows.
    [[nodiscard]] bool keepsAll() const;
    /// Puts the rows in order: then equal parts make equal statistics.
    void sort();
};

[[nodiscard]] bool operator==(const PartValue& a, const PartValue& b);
[[nodiscard]] bool operator==(const ValueStatistics& a, const ValueStatistics& b);
/// Bit for bit; rows in the same order.
[[nodiscard]] bool operator==(const BatchStatistics& a, const BatchStatistics& b);

} // namespace sparkout
