// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/characteristics.h"
#include "core/batch/scenario_source.h"
#include "core/file/text_table.h"
#include "core/statistics/value_bins.h"

#include <array>
#include <cstdint>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// The columns of a table of parts, besides the part's number, its outcome, whether it is good and
/// its least relative margin.
struct PartColumns {
    std::vector<GivenFactor> factors;
    std::vector<Characteristic> characteristics;
    std::vector<ConstraintKind> requirements; ///< by kind, anywhere on the part

    /// Runs the nominal part to find out which settings are required.
    [[nodiscard]] static PartColumns of(const ScenarioSource& source,
                                        const std::stop_token& stop = {});
};

/// "rz1", "section 3" (from 0), or "part".
[[nodiscard]] std::string placeKey(const Characteristic& characteristic);

/// Parts of a batch as lines of CSV.
class PartTable {
public:
    /// The format of numbers and words.
    struct Dialect {
        TableDialect table = {};
        std::string begin, lineEnd = "\n"; ///< of the file, of every line
        /// Completed, does not reach size, completed with strips uncut.
        std::array<std::string, 3> states{"completed", "cannot_reach_size", "strips_uncut"};
        std::string yes = "true", no = "false";
        int firstPart = 0; ///< number of the first part
    };

    PartTable(PartColumns columns, Dialect dialect)
        : m_columns(std::move(columns)), m_dialect(std::move(dialect)) {}

    /// Names of the columns in files: not translated.
    [[nodiscard]] static std::vector<std::string> keys(const PartColumns& columns);
    [[nodiscard]] std::string head(const std::vector<std::string>& names) const;
    /// Numbers that read back as the same double. Cells without a number are empty: for a part that
    /// does not reach size all but its factors, where strips stay uncut the sizes, form and
    /// roughness, and whatever is not required of this part.
    [[nodiscard]] std::string line(const PartRecord& record) const;

private:
    PartColumns m_columns;
    Dialect m_dialect;
};

/// A sum of doubles without rounding: a fixed-point number of 448 bits. Any order and any grouping
/// of the terms gives the same bits, so sums of threads and shards join exactly [KULISCH2008].
///
/// A term is cut to a multiple of 2⁻²²⁴ and must be below 2¹⁹⁰ in size; there may be 2³⁰ of them.
class ExactSum {
public:
    static constexpr int limbs = 14;
    using Limbs = std::array<std::int64_t, limbs>;

    void add(double term);
    void add(const ExactSum& other);
    /// The sum, rounded once to within two units in its last place.
    [[nodiscard]] double value() const;

    /// Digits to the base 2³², the lowest first, each but the last in 0…2³²−1: equal sums have
    /// equal digits.
    [[nodiscard]] Limbs digits() const;
    static ExactSum ofDigits(const Limbs& digits);

    friend bool operator==(const ExactSum& a, const ExactSum& b) {
        return a.digits() == b.digits();
    }

private:
    Limbs m_limbs{}; ///< delayed carries: 2³⁰ terms do not fill 63 bits
};

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
