// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_summary.h"
#include "core/batch/exact_sum.h"
#include "core/batch/intervals.h"
#include "core/batch/philox.h"

#include "tests/core/project_fixtures.h"
#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace test_batch_statistics {

using namespace sparkout;
using fixtures::close;
using fixtures::within;

namespace {

/// Numbers of both signs and very different sizes.
std::vector<double> mixedTerms(int count) {
    std::vector<double> terms;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t bits =
            randomBits(5, RandomStream::plain, static_cast<std::uint64_t>(i), 0);
        terms.push_back(std::ldexp(openUnit(bits) - 0.5, static_cast<int>(bits % 97) - 48));
    }
    return terms;
}

const Characteristic micrometres{"diameter", "µm", Zone::section, 0, -16, 0, 0x1p-6};

ValueStatistics statisticsOf(const std::vector<double>& values) {
    ValueStatistics statistics;
    for (std::size_t i = 0; i < values.size(); ++i) {
        statistics.add(values[i], static_cast<std::int64_t>(i), micrometres);
    }
    return statistics;
}

} // namespace

class TestBatchStatistics : public QObject {
    Q_OBJECT

private slots:
    void aSumLosesNothing() {
        ExactSum sum;
        for (const double term : {0x1p100, 1.0, -0x1p100, 0x1p-100}) {
            sum.add(term);
        }
        QCOMPARE(sum.value(), 1 + 0x1p-100); // 1 to double precision
        sum.add(-1.0);
        QVERIFY(sum.value() == 0x1p-100);
        sum.add(-0x1p-99);
        QVERIFY(sum.value() == -0x1p-100);
        sum.add(0x1p-100);
        QVERIFY(sum == ExactSum());
    }

    void everyOrderAndGroupingGivesTheSameBits() {
        std::vector<double> terms = mixedTerms(1000);
        ExactSum forward, backward, grouped;
        for (const double term : terms) {
            forward.add(term);
        }
        for (std::size_t first = 0; first < terms.size(); first += 37) {
            ExactSum group;
            for (std::size_t i = first; i < std::min(first + 37, terms.size()); ++i) {
                group.add(terms[i]);
            }
            grouped.add(ExactSum::ofDigits(group.digits()));
        }
        std::reverse(terms.begin(), terms.end());
        for (const double term : terms) {
            backward.add(term);
        }
        QVERIFY(forward == backward);
        QVERIFY(forward == grouped);
        long double plain = 0;
        std::sort(terms.begin(), terms.end(),
                  [](double a, double b) { return std::abs(a) < std::abs(b); });
        for (const double term : terms) {
            plain += term;
        }
        QVERIFY(close(forward.value(), static_cast<double>(plain), 1e-14));
    }

    // Student's table: t(0.975; 9) = 2.262157, t(0.975; 49) = 2.009575.
    void theMeansIntervalIsStudents() {
        const Interval ten = studentInterval(5, std::sqrt(10.0), 10, 0.95);
        QVERIFY(within(ten.high - 5, 2.262157, 5e-7));
        QVERIFY(within(5 - ten.low, 2.262157, 5e-7));
        const Interval fifty = studentInterval(0, std::sqrt(50.0), 50, 0.95);
        QVERIFY(within(fifty.high, 2.009575, 5e-7));
    }

    // CLOPPER1934: 5 of 10, 0.1871…0.8129; 1 of 20, 0.0013…0.2487; 0 of n, 1 − 0.025^(1/n).
    void sharesHaveTheTabledBounds() {
        const Interval half = clopperPearson(5, 10, 0.95);
        QVERIFY(within(half.low, 0.1871, 5e-5));
        QVERIFY(within(half.high, 0.8129, 5e-5));
        const Interval few = clopperPearson(1, 20, 0.95);
        QVERIFY(within(few.low, 0.0013, 5e-5));
        QVERIFY(within(few.high, 0.2487, 5e-5));
        const Interval none = clopperPearson(0, 10, 0.95);
        QCOMPARE(none.low, 0.0);
        QVERIFY(close(none.high, 1 - std::pow(0.025, 0.1), 1e-12));
        const Interval all = clopperPearson(10, 10, 0.95);
        QVERIFY(close(all.low, std::pow(0.025, 0.1), 1e-12));
        QCOMPARE(all.high, 1.0);
    }

    // The binomial table: of the median x_(1)…x_(6) of 6, x_(2)…x_(9) of 10, nothing of 5.
    void theMedianLiesBetweenTheTabledRanks() {
        QVERIFY(!quantileRanks(5, 0.5, 0.95));
        const auto six = quantileRanks(6, 0.5, 0.95);
        QVERIFY(six && six->low == 1 && six->high == 6);
        const auto ten = quantileRanks(10, 0.5, 0.95);
        QVERIFY(ten && ten->low == 2 && ten->high == 9);
    }

    // χ² table: 16.047 and 45.722 of 29 degrees of freedom.
    void capabilityHasTheTabledBounds() {
        const Interval cp = cpInterval(1.33, 30, 0.95);
        QVERIFY(close(cp.low, 1.33 * std::sqrt(16.047 / 29), 5e-5));
        QVERIFY(close(cp.high, 1.33 * std::sqrt(45.722 / 29), 5e-5));
        const Interval cpk = cpkInterval(1.2, 30, 0.95);
        const double half = 1.959964 * std::sqrt(1.0 / 270 + 1.44 / 58);
        QVERIFY(within(cpk.high - 1.2, half, 1e-6));
        QVERIFY(within(1.2 - cpk.low, half, 1e-6));
    }

    void momentsAreThoseOfTheDefinition() {
        const std::vector<double> values{-3, -7.5, -9, -2, -11, -4, -4};
        const auto n = static_cast<double>(values.size());
        const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
        double m2 = 0, m3 = 0, m4 = 0;
        for (const double x : values) {
            m2 += std::pow(x - mean, 2) / n;
            m3 += std::pow(x - mean, 3) / n;
            m4 += std::pow(x - mean, 4) / n;
        }
        const Moments found = momentsOf(statisticsOf(values));
        QVERIFY(close(found.mean, mean, 1e-14));
        QVERIFY(close(found.deviation, std::sqrt(m2 * n / (n - 1)), 1e-13));
        QVERIFY(close(found.skewness, m3 / std::pow(m2, 1.5), 1e-11));
        QVERIFY(close(found.excess, m4 / (m2 * m2) - 3, 1e-11));
    }

    void equalValuesHaveNoScatter() {
        const Moments found = momentsOf(statisticsOf({0.1, 0.1, 0.1}));
        QCOMPARE(found.deviation, 0.0);
        QVERIFY(close(found.mean, 0.1, 1e-15));
    }

    void extremesAreOfTheFirstPartThatHasThem() {
        ValueStatistics a, b;
        a.add(-3, 7, micrometres);
        a.add(1, 8, micrometres);
        b.add(-3, 2, micrometres);
        b.add(-17, 9, micrometres);
        ValueStatistics ab = a, ba = b;
        ab.add(b);
        ba.add(a);
        QVERIFY(ab == ba);
        QCOMPARE(ab.least.part, std::int64_t{9});
        QCOMPARE(ab.below, std::int64_t{1});
        QCOMPARE(ab.above, std::int64_t{1});
        QCOMPARE(ab.count, std::int64_t{4});
    }
};

} // namespace test_batch_statistics

SPARKOUT_TEST(test_batch_statistics, TestBatchStatistics)
#include "test_batch_statistics.moc"
