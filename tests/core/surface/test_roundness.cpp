// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/roundness.h"

#include "tests/core/support/dense.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/core/surface/downhill.h"
#include "tests/registry.h"

namespace sparkout::test_roundness {

using fixtures::between;
using fixtures::decades;
using fixtures::holds;
using fixtures::pick;
using fixtures::within;

using Radii = std::vector<double>;

/// R + amplitude·cos(n·φ − phase) of K radii.
Radii lobed(std::size_t K, double R, double amplitude, int n, double phase = 0) {
    Radii radii(K);
    for (std::size_t k = 0; k < K; ++k) {
        radii[k] =
            R + amplitude * std::cos(n * 2 * std::numbers::pi * double(k) / double(K) - phase);
    }
    return radii;
}

/// A true circle about (e, 0) as its radii from the axis.
Radii eccentricCircle(std::size_t K, double R, double e) {
    Radii radii(K);
    for (std::size_t k = 0; k < K; ++k) {
        const double phi = 2 * std::numbers::pi * double(k) / double(K);
        radii[k] = e * std::cos(phi) + std::sqrt(R * R - std::pow(e * std::sin(phi), 2));
    }
    return radii;
}

/// A few lobes, an eccentricity and some noise, together up to `form`.
Radii anyRadii(std::size_t K, double R, double form) {
    Radii radii = lobed(K, R, form * between(0, 0.4), 1, between(0, 6));
    const int n = pick(2, 6);
    const double lobe = form * between(0, 0.3), noise = form * between(0, 0.3);
    for (std::size_t k = 0; k < K; ++k) {
        radii[k] += lobe * std::cos(n * 2 * std::numbers::pi * double(k) / double(K))
                    + noise * between(-1, 1);
    }
    return radii;
}

std::size_t anyEven(int low, int high) {
    return std::size_t(2 * pick(low / 2, high / 2 + 1));
}

double distanceTo(const Radii& radii, std::size_t k, double x, double y) {
    const double phi = 2 * std::numbers::pi * double(k) / double(radii.size());
    return std::hypot(radii[k] * std::cos(phi) - x, radii[k] * std::sin(phi) - y);
}

double width(const Radii& radii, double x, double y) {
    double low = 1e300, high = 0;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double d = distanceTo(radii, k, x, y);
        low = std::min(low, d);
        high = std::max(high, d);
    }
    return high - low;
}

/// Smallest width of the limaçon zone: of every four points the level at which they alternate, the
/// largest of these (de la Vallée-Poussin). η balances {1, cos, sin} on the four.
double limaconBruteForce(const Radii& radii) {
    const int K = int(radii.size());
    double most = 0;
    for (int a = 0; a < K; ++a) {
        for (int b = a + 1; b < K; ++b) {
            for (int c = b + 1; c < K; ++c) {
                for (int d = c + 1; d < K; ++d) {
                    dense::Matrix G(3);
                    std::vector<double> R;
                    for (const int k : {a, b, c, d}) {
                        const double phi = 2 * std::numbers::pi * k / K;
                        G[0].push_back(1);
                        G[1].push_back(std::cos(phi));
                        G[2].push_back(std::sin(phi));
                        R.push_back(radii[std::size_t(k)]);
                    }
                    most = std::max(most, dense::alternation(G, R));
                }
            }
        }
    }
    return 2 * most;
}

/// Smallest width about any centre that many starts lead to.
double circlesBruteForce(const Radii& radii, double reach) {
    const auto at = [&](const std::array<double, 2>& c) { return width(radii, c[0], c[1]); };
    double best = 1e300;
    for (const double x : {-0.8, 0.0, 0.8}) {
        for (const double y : {-0.8, 0.8}) {
            best = std::min(best, fixtures::downhill<2>(at, {x * reach, y * reach}, reach / 3));
        }
    }
    return best;
}

double eccentricity(const RoundnessZone& zone) {
    return std::hypot(zone.x_mm, zone.y_mm);
}

class TestRoundness : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(500); }

    // shared/vectors: e·cos φ has a runout of 2e and no roundness; e·cos 2φ and e·cos 3φ have 2e.
    void formsOfTheVectors_data() {
        addColumns<int, double>("lobes", "roundness_um");
        QTest::newRow("e·cos φ") << 1 << 0.0;
        QTest::newRow("e·cos 2φ") << 2 << 10.0;
        QTest::newRow("e·cos 3φ") << 3 << 10.0;
    }
    void formsOfTheVectors() {
        QFETCH(int, lobes);
        QFETCH(double, roundness_um);
        const double e = 0.005, R = 15;
        const Directions directions(360);
        const Radii radii = lobed(360, R, e, lobes);
        const double um = 1e-3, curvature = e * e / (2 * (R - e)); // circle or limaçon
        QVERIFY(within(leastSquaresCircle(radii, directions).deviation(), roundness_um * um,
                       curvature));
        QVERIFY(within(minimumZoneCircles(radii, directions).deviation(), roundness_um * um,
                       curvature));
        QVERIFY(within(minimumZoneCircles(radii, directions, ZoneModel::limacons).deviation(),
                       roundness_um * um, 1e-14));
        const auto [low, high] = std::minmax_element(radii.begin(), radii.end());
        QVERIFY(within(*high - *low, 2 * e, 1e-14));
    }

    void circleOffTheAxisIsRound() {
        QVERIFY(holds("circle", [] {
            const std::size_t K = anyEven(4, 80);
            const double R = decades(0, 2), e = R * between(0, 0.05);
            const Radii radii = eccentricCircle(K, R, e);
            const Directions directions(K);
            const double digits = 50 * fixtures::epsilon * R;
            for (const RoundnessZone& zone :
                 {leastSquaresCircle(radii, directions), minimumZoneCircles(radii, directions)}) {
                RC_ASSERT(zone.deviation() <= digits);
                RC_ASSERT(within(zone.x_mm, e, digits) && within(zone.y_mm, 0, digits));
                RC_ASSERT(within(zone.reference_mm, R, digits));
            }
        }));
    }

    void roundSectionHasNoDeviationAtAll() {
        const Radii radii(36, 15.0);
        const Directions directions(36);
        QVERIFY(leastSquaresCircle(radii, directions).deviation() <= 1e-14);
        QVERIFY(minimumZoneCircles(radii, directions).deviation() <= 1e-14);
        QCOMPARE(minimumZoneCircles(radii, directions, ZoneModel::limacons).deviation(), 0.0);
    }

    // --- minimum zone against brute force ---

    /// A radius without bounds leaves no number to go by: the circles are those of least squares.
    void whatIsNoNumberEndsTheSearch() {
        std::vector<double> radii(12, 15.0);
        radii[4] = std::numeric_limits<double>::infinity();
        const Directions directions(radii.size());
        const RoundnessZone found = minimumZoneCircles(radii, directions);
        QVERIFY(!std::isfinite(found.deviation()));
    }

    void limaconZoneIsTheBestOfAllFours() {
        QVERIFY(holds("limaçons", [] {
            const std::size_t K = anyEven(4, 12);
            const Radii radii = anyRadii(K, 15, decades(-4, 0));
            const RoundnessZone zone =
                minimumZoneCircles(radii, Directions(K), ZoneModel::limacons);
            RC_ASSERT(within(zone.deviation(), limaconBruteForce(radii), 1e-13));
        }));
    }

    void circleZoneIsTheBestOfAllCentres() {
        QVERIFY(holds("circles", [] {
            const std::size_t K = anyEven(4, 16);
            const double form = decades(-4, -1);
            const Radii radii = anyRadii(K, 15, form);
            const double found = minimumZoneCircles(radii, Directions(K)).deviation();
            const double best = circlesBruteForce(radii, form);
            // the search stops within 1e-12 of its valley's bottom; no other valley is deeper
            RC_ASSERT(within(found, best, 1e-11));
        }));
    }

    // Parts far from round, as only a bad measurement makes them: other valleys may be deeper, but
    // by no more than the header says.
    void circleZoneOfCrookedPartsIsTheBestWithinTheBound() {
        QVERIFY(holds("bound", [] {
            const std::size_t K = anyEven(4, 16);
            const double R = 15, form = between(0.5, 3);
            const Radii radii = anyRadii(K, R, form);
            const double w = minimumZoneCircles(radii, Directions(K)).deviation();
            const double gap = std::cos(std::numbers::pi / double(K));
            const double best = circlesBruteForce(radii, form);
            RC_ASSERT(w <= best + w * w / (2 * (R - w) * gap * gap) + 1e-11);
        }));
    }

    // --- what a zone is ---

    void zoneHoldsEveryPointAndTouchesFourInTurn() {
        QVERIFY(holds("contacts", [] {
            const std::size_t K = anyEven(4, 60);
            const Radii radii = anyRadii(K, 15, decades(-4, -1));
            const RoundnessZone zone = minimumZoneCircles(radii, Directions(K));
            const double digits = 40 * fixtures::epsilon * 15;
            for (std::size_t k = 0; k < K; ++k) {
                const double d = distanceTo(radii, k, zone.x_mm, zone.y_mm);
                RC_ASSERT(d <= zone.outer_mm + digits && d >= zone.inner_mm - digits);
            }
            RC_PRE(zone.deviation() > 1e-9);
            for (std::size_t m = 0; m < 4; ++m) {
                const double d = distanceTo(radii, zone.contacts[m], zone.x_mm, zone.y_mm);
                // a contact of little weight touches less exactly than the width is found
                RC_ASSERT(within(d, m % 2 == 0 ? zone.outer_mm : zone.inner_mm, 1e-11));
            }
            const std::size_t first = zone.contacts[0];
            std::size_t last = 0;
            for (const std::size_t k : zone.contacts) { // once around
                RC_ASSERT((k + K - first) % K >= last);
                last = (k + K - first) % K;
            }
            RC_ASSERT(within(zone.reference_mm, (zone.inner_mm + zone.outer_mm) / 2, digits));
        }));
    }

    // The header's bound on what the limaçon leaves out.
    void limaconsAndCirclesDifferByNoMoreThanTheCurvature() {
        QVERIFY(holds("curvature", [] {
            const std::size_t K = anyEven(4, 60);
            const double R = 15;
            const Radii radii = anyRadii(K, R, decades(-3, 0));
            const Directions directions(K);
            const RoundnessZone circles = minimumZoneCircles(radii, directions);
            const RoundnessZone limacons =
                minimumZoneCircles(radii, directions, ZoneModel::limacons);
            const double e = std::max(eccentricity(circles), eccentricity(limacons));
            const double least = *std::min_element(radii.begin(), radii.end());
            RC_ASSERT(within(circles.deviation(), limacons.deviation(),
                             e * e / (2 * (least - e)) + 1e-13));
        }));
    }

    // --- laws ---

    void shiftOfTheCentreIsNoForm() {
        QVERIFY(holds("shift", [] {
            const std::size_t K = anyEven(4, 40);
            Radii radii = anyRadii(K, 15, decades(-4, -1));
            const Directions directions(K);
            const double before =
                minimumZoneCircles(radii, directions, ZoneModel::limacons).deviation();
            const Radii shift = lobed(K, 0, between(0, 0.1), 1, between(0, 6));
            for (std::size_t k = 0; k < K; ++k) {
                radii[k] += shift[k];
            }
            RC_ASSERT(within(minimumZoneCircles(radii, directions, ZoneModel::limacons).deviation(),
                             before, 1e-13));
        }));
    }

    // --- least squares ---

    // The conditions of the minimum themselves: Σ(d − r) = 0, Σ(d − r)·n = 0.
    void leastSquaresConditionsAreMet() {
        QVERIFY(holds("normal equations", [] {
            const std::size_t K = anyEven(4, 60);
            const Radii radii = anyRadii(K, 15, decades(-3, 0));
            const RoundnessZone zone = leastSquaresCircle(radii, Directions(K));
            double sum = 0, x = 0, y = 0;
            for (std::size_t k = 0; k < K; ++k) {
                const double phi = 2 * std::numbers::pi * double(k) / double(K);
                const double d = distanceTo(radii, k, zone.x_mm, zone.y_mm);
                sum += d - zone.reference_mm;
                x += (d - zone.reference_mm) * (radii[k] * std::cos(phi) - zone.x_mm) / d;
                y += (d - zone.reference_mm) * (radii[k] * std::sin(phi) - zone.y_mm) / d;
            }
            const double digits = 1e-13 * double(K);
            RC_ASSERT(within(sum, 0, digits) && within(x, 0, digits) && within(y, 0, digits));
        }));
    }

    // However wild the radii, an answer comes, and it holds every point.
    void wildRadiiGetAZoneToo() {
        QVERIFY(holds("wild", [] {
            const std::size_t K = anyEven(4, 40);
            Radii radii(K);
            for (double& R : radii) {
                R = between(1, 30);
            }
            const RoundnessZone zone = minimumZoneCircles(radii, Directions(K));
            RC_ASSERT(std::isfinite(zone.deviation()));
            RC_ASSERT(within(width(radii, zone.x_mm, zone.y_mm), zone.deviation(), 1e-12));
            RC_ASSERT(zone.deviation() <= leastSquaresCircle(radii, Directions(K)).deviation());
        }));
    }
};

} // namespace sparkout::test_roundness

SPARKOUT_TEST(test_roundness, TestRoundness)
#include "test_roundness.moc"
