// SPDX-License-Identifier: GPL-3.0-or-later
// The noise of a trace: what neighbours differ by gives it, what is left beyond it is a model that
// does not fit, and where that lies is named.
#include "core/measured/noise_model.h"

#include "core/measured/cycle_response.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "tests/core/measured/measured_cycles.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace sparkout::test_trace_noise {

/// Noise of these variances, n values.
std::vector<double> noiseOf(const TraceNoise& noise, std::size_t count, std::uint32_t seed) {
    const auto normal = [&](std::size_t i, std::uint32_t stream) {
        return normalQuantile(openUnit(randomBits(seed, RandomStream::plain, i, stream)));
    };
    std::vector<double> values;
    double following = std::sqrt(noise.following) * normal(0, 2);
    for (std::size_t i = 0; i < count; ++i) {
        following = noise.phi * following
                    + std::sqrt(noise.following * (1 - noise.phi * noise.phi)) * normal(i, 1);
        values.push_back(following + std::sqrt(noise.white) * normal(i, 0));
    }
    return values;
}

class TestTraceNoise : public QObject {
    Q_OBJECT

private slots:
    /// The variance of a mean is the sum over all pairs of their covariances.
    void varianceOfAMean() {
        const TraceNoise noise{.white = 0.3, .following = 0.7, .phi = 0.85};
        for (const std::size_t count : {1, 2, 7, 40}) {
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t k = 0; k < count; ++k) {
                    const double apart = std::abs(static_cast<double>(i) - static_cast<double>(k));
                    sum +=
                        noise.following * std::pow(noise.phi, apart) + (i == k ? noise.white : 0);
                }
            }
            const double exact = sum / static_cast<double>(count * count);
            QVERIFY(std::abs(noise.varianceOfMean(count) - exact) < 1e-12);
        }
    }

    void noiseIsFoundAgain() {
        const TraceNoise truth{.white = 0.2, .following = 0.8, .phi = 0.8};
        const TraceNoise found = traceNoiseOf(noiseOf(truth, 20'000, 3));
        QVERIFY2(std::abs(found.variance() - 1) < 0.1,
                 qPrintable(QString::number(found.variance())));
        QVERIFY2(std::abs(found.phi - truth.phi) < 0.08, qPrintable(QString::number(found.phi)));
        // A slow wave below it is none: neighbours hardly differ by it.
        std::vector<double> waves = noiseOf({.white = 1}, 2000, 4);
        for (std::size_t i = 0; i < waves.size(); ++i) {
            waves[i] += 2 * std::sin(2 * std::numbers::pi * static_cast<double>(i) / 1000);
        }
        QVERIFY(std::abs(traceNoiseOf(waves).variance() - 1) < 0.15);
        QVERIFY(traceNoiseOf(std::vector<double>(50, 1.0), 0.1).variance() >= 0.01 / 12 - 1e-15);
    }

    void chanceIsHardlyEverALack_data() {
        addColumns<double, double, int>("white", "phi", "count");
        QTest::newRow("white, 100") << 1.0 << 0.0 << 100;
        QTest::newRow("white, 600") << 1.0 << 0.0 << 600;
        QTest::newRow("follows, 600") << 0.0 << 0.9 << 600;
        QTest::newRow("both, 600") << 0.5 << 0.8 << 600;
        QTest::newRow("follows, 4000") << 0.0 << 0.95 << 4000;
    }
    void chanceIsHardlyEverALack() {
        QFETCH(double, white);
        QFETCH(double, phi);
        QFETCH(int, count);
        const int sets = samples::sized(200, 40, 2000);
        int lacking = 0;
        for (int set = 0; set < sets; ++set) {
            const std::vector<double> values =
                noiseOf({white, 1 - white, phi}, static_cast<std::size_t>(count),
                        static_cast<std::uint32_t>(set + 1));
            lacking += lackOfFit(values, traceNoiseOf(values), 0).isLacking();
        }
        qInfo("%s: %d of %d are said to lack", QTest::currentDataTag(), lacking, sets);
        QVERIFY(clopperPearson(lacking, sets, 0.99).low <= 0.05);
    }

    /// A wave as great as the noise is always one.
    void aWaveIsALack() {
        for (std::uint32_t seed = 1; seed <= 20; ++seed) {
            std::vector<double> values = noiseOf({.white = 1}, 600, seed);
            for (std::size_t i = 0; i < values.size(); ++i) {
                values[i] +=
                    std::sqrt(2.0) * std::sin(2 * std::numbers::pi * static_cast<double>(i) / 300);
            }
            QVERIFY(lackOfFit(values, traceNoiseOf(values), 0).isLacking());
        }
    }

    void whatIsUnlikeIsNamed() {
        constexpr std::size_t count = 600;
        const std::vector<double> stageEnds_s{20, 30};
        std::vector<double> time_s, predicted;
        for (std::size_t i = 0; i < count; ++i) {
            time_s.push_back(static_cast<double>(i) / 20);
            predicted.push_back(std::exp(-time_s.back() / 3));
        }
        const auto named = [&](auto what) {
            std::vector<double> residuals = noiseOf({.white = 1}, count, 5);
            for (std::size_t i = 0; i < count; ++i) {
                residuals[i] += what(i);
            }
            return unlikeOf(time_s, predicted, residuals, 1, stageEnds_s);
        };
        QVERIFY(named([&](std::size_t i) { return time_s[i] / 5 - 3; }).kind == Unlike::drift);
        QVERIFY(named([&](std::size_t i) { return -40 * predicted[i] / 3 + 1; }).kind
                == Unlike::lag);
        const UnlikeCycle stage = named([&](std::size_t i) { return time_s[i] > 20 ? 3.0 : -1.5; });
        QVERIFY(stage.kind == Unlike::stage);
        QVERIFY(named([](std::size_t i) { return i % 100 == 50 ? 40.0 : 0.0; }).kind
                == Unlike::spike);
        QVERIFY(named([&](std::size_t i) { return 3 * std::sin(5 * time_s[i]); }).kind
                == Unlike::other);
    }

    /// Far beyond all others, and alone: not an outlier within their range, nor several in a row,
    /// nor what the model predicts.
    void whatIsOverRangeIsTold() {
        constexpr std::size_t count = 200;
        std::vector<double> predicted;
        for (std::size_t i = 0; i < count; ++i) {
            predicted.push_back(0.4 * std::exp(-static_cast<double>(i) / 30));
        }
        const auto found = [&](const std::vector<std::pair<std::size_t, double>>& changed,
                               bool arePredicted = false) {
            std::vector<double> values = noiseOf({.white = 1e-8}, count, 5), residuals = values;
            for (std::size_t i = 0; i < count; ++i) {
                values[i] += predicted[i];
            }
            for (const auto& [i, value] : changed) {
                residuals[i] = arePredicted ? residuals[i] : value - predicted[i];
                values[i] = value;
            }
            return overRange(values, residuals);
        };
        using Indices = std::vector<std::size_t>;
        QCOMPARE(found({}), Indices());
        QCOMPARE(found({{50, 9.999}, {120, -9.999}}), (Indices{50, 120}));
        QCOMPARE(found({{0, 9.999}, {199, 9.999}}), (Indices{0, 199}));
        QCOMPARE(found({{50, 0.5}}), Indices());
        QCOMPARE(found({{50, 9.999}, {51, 9.999}, {52, 9.999}}), Indices());
        QCOMPARE(found({{50, 9.999}}, true), Indices());
        QCOMPARE(overRange(std::vector<double>{1, 2, 90}, std::vector<double>{0, 0, 88}),
                 Indices());
    }

    /// An exponential gauge lags behind a ramp by r·τ·(1 − e^(−t/τ)), and comes to rest.
    void aLaggingGaugeInClosedForm() {
        const std::vector<double> times{0, 2, 3}, values{1, 5, 5};
        constexpr double lag_s = 0.5;
        for (double t = 0; t <= 2; t += 0.1) {
            const double exact = 1 + 2 * t - 2 * lag_s * (1 - std::exp(-t / lag_s));
            QVERIFY(std::abs(measured_cycles::laggedAt(times, values, t, lag_s) - exact) < 1e-12);
        }
        const double atEnd = 2 * lag_s * (1 - std::exp(-2 / lag_s));
        QVERIFY(std::abs(measured_cycles::laggedAt(times, values, 4, lag_s)
                         - (5 - atEnd * std::exp(-2 / lag_s)))
                < 1e-12);
        QCOMPARE(measured_cycles::laggedAt(times, values, 1, 0), valueAt(times, values, 1));
        QCOMPARE(measured_cycles::laggedAt(times, values, 1, -0.25), valueAt(times, values, 1.25));
    }
};

} // namespace sparkout::test_trace_noise

SPARKOUT_TEST(test_trace_noise, TestTraceNoise)
#include "test_trace_noise.moc"
