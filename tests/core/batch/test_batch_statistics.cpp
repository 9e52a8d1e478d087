// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_statistics.h"
#include "core/batch/batch_summary.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <numeric>
#include <utility>

namespace sparkout::test_batch_statistics {

using fixtures::close;
using fixtures::within;

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

constexpr std::size_t mostBins = 4096;

ValueStatistics statisticsOf(const std::vector<double>& values) {
    ValueStatistics statistics;
    for (std::size_t i = 0; i < values.size(); ++i) {
        statistics.add(values[i], static_cast<std::int64_t>(i), micrometres, {}, mostBins);
    }
    return statistics;
}

/// Of values in bins so narrow that each stands alone.
Normality binnedNormality(const std::vector<double>& values) {
    const ValueStatistics statistics = statisticsOf(values);
    const Moments moments = momentsOf(statistics);
    return andersonDarling(statistics.bins, micrometres.resolution, statistics.count, moments.mean,
                           moments.deviation);
}

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
        const Interval pp = ppInterval(1.33, 30, 0.95);
        QVERIFY(close(pp.low, 1.33 * std::sqrt(16.047 / 29), 5e-5));
        QVERIFY(close(pp.high, 1.33 * std::sqrt(45.722 / 29), 5e-5));
        const Interval ppk = ppkInterval(1.2, 30, 0.95);
        const double half = 1.959964 * std::sqrt(1.0 / 270 + 1.44 / 58);
        QVERIFY(within(ppk.high - 1.2, half, 1e-6));
        QVERIFY(within(1.2 - ppk.low, half, 1e-6));
    }

    // SHAPIRO1965, weights of 11 men, W = 0.79; ROYSTON1995, the example of AS R94, W = 0.83467 and
    // p = 0.000914 in its single precision.
    void shapiroAndWilksTestGivesThePublishedFigures() {
        const std::vector<double> men{148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236};
        const Normality few = shapiroWilk(men);
        QVERIFY(few.test == NormalityTest::shapiroWilk);
        QVERIFY(within(few.statistic, 0.79, 0.005) && within(few.probability, 0.0067, 5e-5));
        const std::vector<double> royston{0.139, 0.157, 0.175, 0.256, 0.344, 0.413, 0.503,
                                          0.577, 0.614, 0.655, 0.954, 1.392, 1.557, 1.648,
                                          1.690, 1.994, 2.174, 2.206, 3.245, 3.510, 3.571,
                                          4.354, 4.980, 6.084, 8.351};
        const Normality skew = shapiroWilk(royston);
        QVERIFY(within(skew.statistic, 0.83467, 5e-6));
        QVERIFY(within(skew.probability, 0.000914, 1e-6));
    }

    // STEPHENS1974, weights of 20 chicks, A² = 0.214 of estimated mean and deviation; the tabled
    // points of A²·(1 + 0.75/n + 2.25/n²) of DAGOSTINO1986: 0.631, 0.752, 0.873 and 1.035 at 10, 5,
    // 2.5 and 1 %.
    void andersonAndDarlingsTestGivesThePublishedFigures() {
        const std::vector<double> chicks{156, 162, 168, 182, 186, 190, 190, 196, 202, 210,
                                         214, 220, 226, 230, 230, 236, 236, 242, 246, 270};
        const Normality found = binnedNormality(chicks);
        QVERIFY(found.test == NormalityTest::andersonDarling);
        QVERIFY(within(found.statistic, 0.214, 5e-4));
        QVERIFY(found.probability > 0.8 && found.probability < 0.9);
        for (const auto& [statistic, probability] :
             {std::pair(0.631, 0.10), std::pair(0.752, 0.05), std::pair(0.873, 0.025),
              std::pair(1.035, 0.01)}) {
            QVERIFY(close(andersonDarlingProbability(statistic, 1e9), probability, 0.02));
        }
        QCOMPARE(andersonDarlingProbability(200, 1e9), 0.0);
    }

    /// Quantiles of a normal law pass, those of a uniform one do not, in bins as one by one.
    void aLargeBatchIsTestedInBins() {
        std::vector<double> bell, flat;
        for (int i = 0; i < 20'000; ++i) {
            const double share = (i + 0.5) / 20'000;
            bell.push_back(-8 + 2 * normalQuantile(share));
            flat.push_back(-8 + 4 * share);
        }
        QVERIFY(binnedNormality(bell).probability > 0.99);
        QVERIFY(binnedNormality(flat).probability < 1e-9);
    }

    /// As few bins as are allowed, as narrow as that allows, whatever the order and the grouping.
    void binsAreThoseOfTheValuesAlone() {
        std::vector<double> values;
        for (int i = 0; i < 3000; ++i) {
            const double share = openUnit(randomBits(3, RandomStream::plain, std::uint64_t(i), 0));
            values.push_back(i % 500 == 0 ? 1e12 * (share - 0.5) : -8 + normalQuantile(share));
        }
        ValueBins forward, backward, grouped;
        const auto add = [&](ValueBins& bins, std::size_t i) {
            bins.add(values[i], 0x1p-6, {static_cast<std::int32_t>(i), -7}, 512);
        };
        for (std::size_t i = 0; i < values.size(); ++i) {
            add(forward, i);
            add(backward, values.size() - 1 - i);
        }
        for (std::size_t first = 0; first < values.size(); first += 700) {
            ValueBins group;
            for (std::size_t i = first; i < std::min(first + 700, values.size()); ++i) {
                add(group, i);
            }
            grouped.add(group, 512);
        }
        QVERIFY(forward == backward && forward == grouped);
        QVERIFY(forward.bins().size() <= 512 && forward.level() > 0);
        ValueBins finer;
        for (std::size_t i = 0; i < values.size(); ++i) {
            finer.add(values[i], 0x1p-6, {}, values.size());
        }
        QVERIFY(finer.atLeast(forward.level() - 1).bins().size() > 512);
        std::int64_t count = 0, scores = 0;
        for (const auto& [number, bin] : forward.bins()) {
            count += bin.count;
            scores += bin.scores[0];
            QCOMPARE(bin.scores[1], -7 * bin.count);
        }
        QCOMPARE(count, std::int64_t{3000});
        QCOMPARE(scores, std::int64_t{3000 * 2999 / 2});
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

    /// Skewness and excess do not change with the size of the values: they come out, or are not
    /// stated where rounding hides them.
    void theShapeOfALittleScatterIsRightOrNotStated() {
        const std::vector<double> pattern{-3, -7, -9, -2, -11, -4, -4, 6};
        const Moments around0 = momentsOf(statisticsOf(pattern));
        int stated = 0, hidden = 0;
        for (int power = 0; power < 40; ++power) {
            std::vector<double> values;
            for (const double each : pattern) {
                values.push_back(1 + std::ldexp(each, -power)); // exact
            }
            const Moments found = momentsOf(statisticsOf(values));
            for (const auto& [value, expected] : {std::pair(found.skewness, around0.skewness),
                                                  std::pair(found.excess, around0.excess)}) {
                QVERIFY2(std::isnan(value) || std::abs(value - expected) < 1e-3,
                         qPrintable(QStringLiteral("%1 for %2").arg(value).arg(expected)));
                ++(std::isnan(value) ? hidden : stated);
            }
        }
        QVERIFY(stated > 20 && hidden > 20);
    }

    void equalValuesHaveNoScatter() {
        const Moments found = momentsOf(statisticsOf({0.1, 0.1, 0.1}));
        QCOMPARE(found.deviation, 0.0);
        QVERIFY(close(found.mean, 0.1, 1e-15));
    }

    void extremesAreOfTheFirstPartThatHasThem() {
        ValueStatistics a, b;
        a.add(-3, 7, micrometres, {}, mostBins);
        a.add(1, 8, micrometres, {}, mostBins);
        b.add(-3, 2, micrometres, {}, mostBins);
        b.add(-17, 9, micrometres, {}, mostBins);
        ValueStatistics ab = a, ba = b;
        ab.add(b, mostBins);
        ba.add(a, mostBins);
        QVERIFY(ab == ba);
        QCOMPARE(ab.least.part, std::int64_t{9});
        QCOMPARE(ab.below, std::int64_t{1});
        QCOMPARE(ab.above, std::int64_t{1});
        QCOMPARE(ab.count, std::int64_t{4});
    }
};

} // namespace sparkout::test_batch_statistics

SPARKOUT_TEST(test_batch_statistics, TestBatchStatistics)
#include "test_batch_statistics.moc"
