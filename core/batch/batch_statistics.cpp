// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_statistics.h"

#include "core/file/csv_line.h"
#include "core/quality/constraints.h"
#include "core/quality/result_names.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sparkout {

PartColumns PartColumns::of(const ScenarioSource& source, const std::stop_token& stop) {
    PartColumns columns{source.factors(), characteristicsOf(source.nominal()), {}};
    std::array<bool, constraintKinds> asked{};
    for (const ConstraintResult& constraint :
         evaluateConstraints(simulateUnchecked(source.nominal(), nullptr, stop))) {
        asked[static_cast<std::size_t>(constraint.kind)] = true;
    }
    for (const Requirement& row : requirementRows) {
        if (asked[static_cast<std::size_t>(row.kind)]
            || std::ranges::find(columns.characteristics, &row, &Characteristic::requirement)
                   != columns.characteristics.end()) {
            columns.requirements.push_back(row.kind);
        }
    }
    return columns;
}

std::string placeKey(const Characteristic& characteristic) {
    return sectionOrPart(characteristic.zone, characteristic.section);
}

std::vector<std::string> PartTable::keys(const PartColumns& columns) {
    std::vector<std::string> keys{"part", "status", "good", "least_relative_margin"};
    for (const GivenFactor& factor : columns.factors) {
        keys.emplace_back(factorKey(factor));
    }
    for (const Characteristic& of : columns.characteristics) {
        keys.push_back(std::string(of.name) + ' ' + placeKey(of) + " [" + of.unit + ']');
    }
    for (const ConstraintKind kind : columns.requirements) {
        keys.push_back(std::string(requirementOf(kind).key) + " holds");
    }
    return keys;
}

std::string PartTable::head(const std::vector<std::string>& names) const {
    CsvLine line(m_dialect.table);
    for (const std::string& name : names) {
        line.text(name);
    }
    return m_dialect.begin + line.end(m_dialect.lineEnd);
}

std::string PartTable::line(const PartRecord& record) const {
    const PartOutcome& outcome = record.outcome;
    const bool done = outcome.completed;
    const bool whole = done && !outcome.fails[static_cast<std::size_t>(ConstraintKind::overlap)];
    const auto word = [this](bool yes) { return yes ? m_dialect.yes : m_dialect.no; };
    CsvLine line(m_dialect.table);
    line.whole(record.part + m_dialect.firstPart)
        .text(m_dialect.states[!done   ? 1
                               : whole ? 0
                                       : 2])
        .text(word(outcome.good));
    const double none = std::numeric_limits<double>::quiet_NaN();
    line.number(whole ? outcome.margin : none);
    for (const double value : record.factors) {
        line.number(value);
    }
    for (std::size_t i = 0; i < m_columns.characteristics.size(); ++i) {
        line.number(done ? outcome.values[i] : none);
    }
    for (const ConstraintKind kind : m_columns.requirements) {
        const auto at = static_cast<std::size_t>(kind);
        const bool known = whole || !requirementOf(kind).isOfSurface(); // otherwise: not met
        line.text(done && outcome.asked[at] ? word(known && !outcome.fails[at]) : std::string());
    }
    return line.end(m_dialect.lineEnd);
}

namespace {

constexpr int limbBits = 32;
constexpr int lowestBit = -224;
constexpr std::uint64_t limbMask = 0xFFFFFFFF;

} // namespace

// |term| = m·2^e with m < 2⁵³, laid over up to three limbs.
void ExactSum::add(double term) {
    assert(std::isfinite(term) && std::abs(term) < 0x1p190);
    int e = 0;
    auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(term), &e), 53));
    int shift = e - 53 - lowestBit;
    if (shift < 0) {
        m = shift <= -53 ? 0 : m >> -shift;
        shift = 0;
    }
    const std::int64_t sign = term < 0 ? -1 : 1;
    const auto at = static_cast<std::size_t>(shift / limbBits);
    const std::uint64_t low = (m & limbMask) << (shift % limbBits);
    const std::uint64_t high = (m >> limbBits) << (shift % limbBits);
    m_limbs[at] += sign * static_cast<std::int64_t>(low & limbMask);
    m_limbs[at + 1] += sign * static_cast<std::int64_t>((low >> limbBits) + (high & limbMask));
    m_limbs[at + 2] += sign * static_cast<std::int64_t>(high >> limbBits);
}

void ExactSum::add(const ExactSum& other) {
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        m_limbs[i] += other.m_limbs[i];
    }
}

ExactSum::Limbs ExactSum::digits() const {
    Limbs digits = m_limbs;
    for (std::size_t i = 0; i + 1 < digits.size(); ++i) {
        const std::int64_t carry = digits[i] >> limbBits; // rounds down, also below zero
        digits[i] &= static_cast<std::int64_t>(limbMask);
        digits[i + 1] += carry;
    }
    return digits;
}

ExactSum ExactSum::ofDigits(const Limbs& digits) {
    ExactSum sum;
    sum.m_limbs = digits;
    return sum;
}

// The digits of a negative sum are those of its complement, so its opposite is evaluated.
double ExactSum::value() const {
    Limbs digits = this->digits();
    const bool negative = digits.back() < 0;
    if (negative) {
        ExactSum opposite;
        for (std::size_t i = 0; i < digits.size(); ++i) {
            opposite.m_limbs[i] = -digits[i];
        }
        digits = opposite.digits();
    }
    double sum = 0;
    for (std::size_t i = digits.size(); i-- > 0;) {
        sum +=
            std::ldexp(static_cast<double>(digits[i]), lowestBit + limbBits * static_cast<int>(i));
    }
    return negative ? -sum : sum;
}

namespace {

constexpr double slack = diameterSlack_mm * units::umPerMm;

void keepLeast(PartValue& kept, const PartValue& other) {
    if (other.part >= 0
        && (kept.part < 0 || other.value < kept.value
            || (other.value == kept.value && other.part < kept.part))) {
        kept = other;
    }
}

void keepMost(PartValue& kept, const PartValue& other) {
    if (other.part >= 0
        && (kept.part < 0 || other.value > kept.value
            || (other.value == kept.value && other.part < kept.part))) {
        kept = other;
    }
}

bool sameBitsOf(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

} // namespace

void ValueStatistics::add(double value, std::int64_t part, const Characteristic& characteristic,
                          const RankScores& scores, std::size_t mostBins) {
    ++count;
    double power = value;
    for (ExactSum& sum : powers) {
        sum.add(power);
        power *= value;
    }
    keepLeast(least, {value, part});
    keepMost(most, {value, part});
    below += characteristic.low && value < *characteristic.low - slack ? 1 : 0;
    above += characteristic.high && value > *characteristic.high + slack ? 1 : 0;
    bins.add(value, characteristic.resolution, scores, mostBins);
    for (std::size_t i = 0; i < factorKinds; ++i) {
        for (std::size_t j = i; j < factorKinds; ++j) {
            products[productPlace(i, j)] += std::int64_t{scores[i]} * scores[j];
        }
    }
}

void ValueStatistics::add(const ValueStatistics& other, std::size_t mostBins) {
    count += other.count;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        powers[i].add(other.powers[i]);
    }
    keepLeast(least, other.least);
    keepMost(most, other.most);
    below += other.below;
    above += other.above;
    bins.add(other.bins, mostBins);
    for (std::size_t i = 0; i < products.size(); ++i) {
        products[i] += other.products[i];
    }
}

void BatchStatistics::add(const PartOutcome& outcome, std::int64_t part,
                          const std::vector<Characteristic>& characteristics,
                          const RankScores& scores) {
    ++parts;
    failed += outcome.completed ? 0 : 1;
    bad += outcome.good ? 0 : 1;
    for (std::size_t i = 0; i < rejects.size(); ++i) {
        rejects[i] += outcome.fails[i] ? 1 : 0;
    }
    keepLeast(worst,
              {outcome.completed ? outcome.margin : std::numeric_limits<double>::lowest(), part});
    values.resize(characteristics.size());
    const std::size_t mostBins = ValueBins::mostFor(values.size());
    for (std::size_t i = 0; i < outcome.values.size(); ++i) {
        if (std::isfinite(outcome.values[i])) {
            values[i].add(outcome.values[i], part, characteristics[i], scores, mostBins);
        }
    }
    if (part < keptRows && outcome.completed) {
        rows.push_back({part, outcome.values});
    }
}

void BatchStatistics::add(const BatchStatistics& other) {
    parts += other.parts;
    failed += other.failed;
    bad += other.bad;
    for (std::size_t i = 0; i < rejects.size(); ++i) {
        rejects[i] += other.rejects[i];
    }
    keepLeast(worst, other.worst);
    values.resize(std::max(values.size(), other.values.size()));
    const std::size_t mostBins = ValueBins::mostFor(values.size());
    for (std::size_t i = 0; i < other.values.size(); ++i) {
        values[i].add(other.values[i], mostBins);
    }
    rows.insert(rows.end(), other.rows.begin(), other.rows.end());
}

bool BatchStatistics::keepsAll() const {
    return static_cast<std::int64_t>(rows.size()) + failed == parts;
}

void BatchStatistics::sort() {
    std::sort(rows.begin(), rows.end(),
              [](const PartRow& a, const PartRow& b) { return a.part < b.part; });
}

bool operator==(const PartValue& a, const PartValue& b) {
    return a.part == b.part && sameBitsOf(a.value, b.value);
}

bool operator==(const ValueStatistics& a, const ValueStatistics& b) {
    return a.count == b.count && a.powers == b.powers && a.least == b.least && a.most == b.most
           && a.below == b.below && a.above == b.above && a.bins == b.bins
           && a.products == b.products;
}

bool operator==(const BatchStatistics& a, const BatchStatistics& b) {
    const auto sameRow = [](const PartRow& x, const PartRow& y) {
        return x.part == y.part
               && std::equal(x.values.begin(), x.values.end(), y.values.begin(), y.values.end(),
                             sameBitsOf);
    };
    return a.parts == b.parts && a.failed == b.failed && a.bad == b.bad && a.worst == b.worst
           && a.rejects == b.rejects && a.values == b.values
           && std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(), sameRow);
}

// Central moments from the raw ones, m₂ = M₂ − M², m₃ = M₃ − 3·M·M₂ + 2·M³, m₄ = M₄ − 4·M·M₃ +
// 6·M²·M₂ − 3·M⁴. The raw ones are rounded to doubles, each power and each sum: the total error of
// the terms, up to 6·M³ and 14·M⁴, is three units in the last place, which matters where the
// scatter is small relative to the mean.
Moments momentsOf(const ValueStatistics& values) {
    Moments found;
    if (values.count == 0) {
        return found;
    }
    const auto n = static_cast<long double>(values.count);
    const long double M = values.powers[0].value() / n, M2 = values.powers[1].value() / n;
    const long double M3 = values.powers[2].value() / n, M4 = values.powers[3].value() / n;
    found.mean = static_cast<double>(M);
    if (values.least.value == values.most.value) {
        return found;
    }
    const long double m2 = std::max(M2 - M * M, 0.0L);
    if (m2 <= 0) {
        found.skewness = found.excess = std::numeric_limits<double>::quiet_NaN();
        return found;
    }
    found.deviation = static_cast<double>(std::sqrt(m2 * n / (n - 1)));
    const long double s = std::sqrt(m2), size = std::abs(M) / s;
    const auto ifKnown = [](long double value, long double off) {
        constexpr long double most = 1e-3L;
        return off < most ? static_cast<double>(value) : std::numeric_limits<double>::quiet_NaN();
    };
    constexpr long double error = 3 * std::numeric_limits<double>::epsilon();
    found.skewness =
        ifKnown((M3 - 3 * M * M2 + 2 * M * M * M) / (m2 * s), 6 * error * size * size * size);
    found.excess = ifKnown((M4 - 4 * M * M3 + 6 * M * M * M2 - 3 * M * M * M * M) / (m2 * m2) - 3,
                           14 * error * size * size * size * size);
    return found;
}

} // namespace sparkout
