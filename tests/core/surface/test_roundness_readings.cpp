// SPDX-License-Identifier: GPL-3.0-or-later
// Roundness as measuring machines state it: the Gaussian filter's transmission, and the four
// reference circles against closed forms and against plain searches for the best centre.
#include "core/surface/roundness_readings.h"

#include "core/surface/harmonics.h"
#include "core/surface/roundness.h"
#include "tests/check_line.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/core/surface/downhill.h"
#include "tests/registry.h"

#include <functional>

namespace sparkout::test_roundness_readings {

using fixtures::between;
using fixtures::holds;
using fixtures::pick;

using Radii = std::vector<double>;

constexpr double R = 15, um = 1e-3;

double angle(std::size_t k, std::size_t K) {
    return 2 * std::numbers::pi * double(k) / double(K);
}

/// R + amplitude·cos(n·φ − phase).
Radii lobed(std::size_t K, double amplitude, int n, double phase = 0) {
    Radii radii(K);
    for (std::size_t k = 0; k < K; ++k) {
        radii[k] = R + amplitude * std::cos(n * angle(k, K) - phase);
    }
    return radii;
}

Radii sum(const Radii& a, const Radii& b) {
    Radii radii(a);
    for (std::size_t k = 0; k < a.size(); ++k) {
        radii[k] += b[k] - R;
    }
    return radii;
}

/// Lobes of several numbers and noise, some micrometres high.
Radii anyRadii(std::size_t K) {
    Radii radii = lobed(K, between(0, 6) * um, pick(2, 7), between(0, 6));
    for (double& radius : radii) {
        radius += between(-1, 1) * um;
    }
    return radii;
}

/// The radii of the same section about another axis, e off in the direction φ_0: of points that
/// turn with it, so of an exact limaçon's remainder e²/2R.
Radii offCentre(const Radii& radii, double e, double phi0) {
    return sum(radii, lobed(radii.size(), e, 1, phi0));
}

double distanceTo(const Radii& radii, std::size_t k, double x, double y) {
    const double phi = angle(k, radii.size());
    return std::hypot(radii[k] * std::cos(phi) - x, radii[k] * std::sin(phi) - y);
}

/// The least and greatest distance of the points from a centre.
std::pair<double, double> distances(const Radii& radii, double x, double y) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double d = distanceTo(radii, k, x, y);
        low = std::min(low, d);
        high = std::max(high, d);
    }
    return {low, high};
}

/// The best value of `f` over centres, that starts all around lead to.
double bestCentre(const std::function<double(double, double)>& f) {
    double best = std::numeric_limits<double>::infinity();
    const auto at = [&](const std::array<double, 2>& c) { return f(c[0], c[1]); };
    for (const double x : {-3 * um, 0.0, 3 * um}) {
        for (const double y : {-3 * um, 3 * um}) {
            best = std::min(best, fixtures::downhill<2>(at, {x, y}, 2 * um));
        }
    }
    return best;
}

double amplitudeOf(const Radii& radii, int n) {
    return harmonics(radii, Directions(radii.size()))[std::size_t(n)].amplitude_mm;
}

Radii turned(const Radii& radii, std::size_t by) {
    Radii other(radii);
    std::rotate(other.begin(), other.begin() + std::ptrdiff_t(by), other.end());
    return other;
}

/// A deviation about each of the four circles.
std::vector<double> deviationsOf(const RoundnessReading& reading) {
    return {reading.minimumZone.deviation(), reading.leastSquares.deviation(),
            reading.inscribed.value().deviation(), reading.circumscribed.value().deviation()};
}

class TestRoundnessReadings : public QObject {
    Q_OBJECT

private slots:
    void halfOfAWavePassesAtTheCutOff() {
        for (const int cutoff : roundnessCutoffs_upr) {
            QVERIFY(std::abs(gaussianTransmission(cutoff, cutoff) - 0.5) < 1e-15);
            QCOMPARE(gaussianTransmission(0, cutoff), 1.0);
            // ISO 16610-21's table of the weighting function's transform: 1/16 at twice the cut-off
            QVERIFY(std::abs(gaussianTransmission(2 * cutoff, cutoff) - 1.0 / 16) < 1e-15);
        }
    }

    void aPureLobeKeepsItsFormAndLosesItsShare() {
        for (const std::size_t K : {360U, 361U}) {
            const Directions directions(K);
            for (const int n : {2, 3, 15, 40, 150}) {
                for (const int cutoff : roundnessCutoffs_upr) {
                    const Radii filtered =
                        gaussianFiltered(lobed(K, 5 * um, n, 0.7), directions, cutoff);
                    const double share =
                        std::exp(-std::numbers::ln2 * double(n * n) / double(cutoff * cutoff));
                    const Radii wanted = lobed(K, share * 5 * um, n, 0.7);
                    for (std::size_t k = 0; k < K; ++k) {
                        QVERIFY(std::abs(filtered[k] - wanted[k]) < 1e-13 * R);
                    }
                }
            }
        }
    }

    /// The same by the convolution that the standard defines, on a profile of many waves.
    void theFilterIsTheConvolutionWithTheGaussianWeight() {
        constexpr std::size_t K = 720;
        constexpr double cutoff = 15;
        const Radii radii =
            sum(sum(lobed(K, 4 * um, 2, 1), lobed(K, 2 * um, 9, 2)), lobed(K, 1 * um, 31, 3));
        const Radii filtered = gaussianFiltered(radii, Directions(K), cutoff);
        const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);
        const double wave = 2 * std::numbers::pi / cutoff; // of the cut-off, as an angle
        for (const std::size_t k : {0U, 100U, 433U}) {
            double sums = 0, weights = 0;
            for (int i = -int(K); i <= int(K); ++i) {
                const double phi = 2 * std::numbers::pi * i / double(K);
                const double weight =
                    std::exp(-std::numbers::pi * std::pow(phi / (alpha * wave), 2));
                sums += weight * radii[(k + std::size_t(i + int(K))) % K];
                weights += weight;
            }
            QVERIFY(std::abs(filtered[k] - sums / weights) < 1e-11);
        }
    }

    void aFilterLeavesNoGapFilled() {
        Radii radii = lobed(90, 5 * um, 3);
        for (std::size_t k = 10; k < 16; ++k) {
            radii[k] = std::numeric_limits<double>::quiet_NaN();
        }
        const Radii filtered = gaussianFiltered(radii, Directions(90), 50);
        for (std::size_t k = 0; k < radii.size(); ++k) {
            QCOMPARE(std::isnan(filtered[k]), k >= 10 && k < 16);
            QVERIFY(std::isnan(radii[k]) || std::abs(filtered[k] - radii[k]) < 0.5 * um);
        }
    }

    /// Of an even number of lobes all four circles are about the middle: peak to valley.
    void evenLobesHaveAllFourAboutTheMiddle() {
        for (const int n : {2, 4, 6}) {
            const RoundnessReading reading = roundnessReading(lobed(360, 5 * um, n), std::nullopt);
            for (const double deviation : deviationsOf(reading)) {
                QVERIFY(std::abs(deviation - 10 * um) < 1e-8);
            }
            QVERIFY(std::abs(reading.inscribed->reference_mm - (R - 5 * um)) < 1e-8);
            QVERIFY(std::abs(reading.circumscribed->reference_mm - (R + 5 * um)) < 1e-8);
        }
    }

    /// Inside an ellipse lies the circle of the minor axis, about it that of the major one.
    void circlesOfAnEllipse() {
        constexpr std::size_t K = 360;
        const double a = R, b = R - 20 * um;
        Radii radii(K);
        for (std::size_t k = 0; k < K; ++k) {
            const double phi = angle(k, K);
            radii[k] = a * b / std::hypot(b * std::cos(phi), a * std::sin(phi));
        }
        const Radii off = offCentre(radii, 3 * um, 1.1);
        for (const Radii& profile : {radii, off}) {
            const Directions directions(K);
            const double limacon = std::pow(3 * um, 2) / R;
            const auto inner = maximumInscribedCircle(profile, directions);
            const auto outer = minimumCircumscribedCircle(profile, directions);
            QVERIFY(inner && outer);
            QVERIFY(std::abs(inner->reference_mm - b) < limacon + 1e-8);
            QVERIFY(std::abs(outer->reference_mm - a) < limacon + 1e-8);
        }
    }

    void noCentreHoldsALargerOrASmallerCircle() {
        QVERIFY(holds("MCC and MIC are the best of all centres", [] {
            const auto K = std::size_t(2 * pick(6, 30));
            const Radii radii = anyRadii(K);
            const Directions directions(K);
            const auto inner = maximumInscribedCircle(radii, directions);
            const auto outer = minimumCircumscribedCircle(radii, directions);
            RC_ASSERT(inner && outer);
            const double most =
                -bestCentre([&](double x, double y) { return -distances(radii, x, y).first; });
            const double least =
                bestCentre([&](double x, double y) { return distances(radii, x, y).second; });
            // The curvature of the distances, e²/2R of shifts up to the form.
            const double curvature = std::pow(10 * um, 2) / (2 * R);
            RC_ASSERT(inner->reference_mm > most - curvature);
            RC_ASSERT(outer->reference_mm < least + curvature);
            RC_ASSERT(distances(radii, inner->x_mm, inner->y_mm).first
                      >= inner->reference_mm - 1e-12);
            RC_ASSERT(distances(radii, outer->x_mm, outer->y_mm).second
                      <= outer->reference_mm + 1e-12);
        }));
    }

    /// A part turned or set off on the machine's table has the same roundness, up to the limaçon.
    void neitherTurnNorCentreMatters() {
        QVERIFY(holds("invariance", [] {
            const auto K = std::size_t(4 * pick(5, 45));
            const Radii radii = anyRadii(K);
            const double e = between(0, 2) * um;
            const Radii other =
                turned(offCentre(radii, e, between(0, 6)), std::size_t(pick(0, int(K) - 1)));
            const auto one = roundnessReadings(radii), two = roundnessReadings(other);
            for (std::size_t i = 0; i < one.size(); ++i) {
                // A filter takes its share of the eccentricity, too, which no circle sees.
                const double limacon = 2 * std::pow(e + 10 * um, 2) / R;
                const auto same = [limacon](double a, double b) {
                    return std::abs(a - b) < limacon;
                };
                RC_ASSERT(same(one[i].minimumZone.deviation(), two[i].minimumZone.deviation()));
                RC_ASSERT(same(one[i].leastSquares.deviation(), two[i].leastSquares.deviation()));
                // Where two points hold a circle its centre may move; its size may not.
                RC_ASSERT(same(one[i].inscribed->reference_mm, two[i].inscribed->reference_mm));
                RC_ASSERT(
                    same(one[i].circumscribed->reference_mm, two[i].circumscribed->reference_mm));
            }
        }));
    }

    void aHigherCutOffLetsMoreThrough() {
        const Radii radii = sum(lobed(360, 3 * um, 2), lobed(360, 1 * um, 60));
        const auto readings = roundnessReadings(radii);
        QCOMPARE(readings.size(), std::size_t{4});
        QVERIFY(!readings[0].cutoff_upr);
        for (std::size_t i = 1; i < readings.size(); ++i) {
            QCOMPARE(*readings[i].cutoff_upr, roundnessCutoffs_upr[i - 1]);
        }
        QVERIFY(readings[1].leastSquares.deviation() < readings[2].leastSquares.deviation());
        QVERIFY(readings[2].leastSquares.deviation() < readings[3].leastSquares.deviation());
        QVERIFY(readings[3].leastSquares.deviation() < readings[0].leastSquares.deviation());
        QVERIFY(std::abs(amplitudeOf(gaussianFiltered(radii, Directions(360), 15), 60)
                         - um * std::pow(2, -16))
                < 1e-12);
    }

    void wideGapsHoldNoCircle() {
        Radii radii = lobed(72, 5 * um, 3);
        std::fill(radii.begin(), radii.begin() + 20, std::numeric_limits<double>::quiet_NaN());
        QVERIFY(roundnessReading(radii, 15).inscribed);
        std::fill(radii.begin(), radii.begin() + 40, std::numeric_limits<double>::quiet_NaN());
        const RoundnessReading reading = roundnessReading(radii, std::nullopt);
        QVERIFY(!reading.inscribed && !reading.circumscribed);
        QVERIFY(reading.minimumZone.deviation() > 0);
    }
};

} // namespace sparkout::test_roundness_readings

SPARKOUT_TEST(test_roundness_readings, TestRoundnessReadings)
#include "test_roundness_readings.moc"
