// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/surface/ground_bodies.h"
#include "tests/registry.h"

namespace sparkout::test_cylindricity {

using namespace ground_bodies;

class TestCylindricity : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(200); }

    // --- cylinders ---

    void cylinderThatLeansIsOne() {
        QVERIFY(holds("cylinder", [] {
            const std::vector<double> positions{3, 20, 45, 90};
            const Axis axis{between(-0.1, 0.1), between(-0.1, 0.1), between(-0.002, 0.002),
                            between(-0.002, 0.002)};
            const std::size_t K = std::size_t(2 * pick(2, 30));
            const Body body = leaningCylinder(positions, K, 15, axis);
            const auto shapes = body.shapes();
            const Directions directions(K);
            for (const CylinderZone& zone : {leastSquaresCylinder(shapes, directions),
                                             minimumZoneCylinder(shapes, directions)}) {
                RC_ASSERT(zone.deviation() <= 4e-12);
                RC_ASSERT(within(zone.slopeX, axis.slopeX, 4e-12));
                RC_ASSERT(within(zone.slopeY, axis.slopeY, 4e-12));
                RC_ASSERT(within(zone.x_mm, axis.x + axis.slopeX * zone.position_mm, 4e-12));
                RC_ASSERT(within(zone.y_mm, axis.y + axis.slopeY * zone.position_mm, 4e-12));
                RC_ASSERT(within(zone.reference_mm, 15, 4e-12));
            }
        }));
    }

    // Cone and barrel, round all over: the zone is what the radius varies by.
    void coneAndBarrelDeviateByTheirRadii() {
        const std::size_t K = 36;
        for (const bool cone : {true, false}) {
            Body body;
            for (int j = 0; j < 9; ++j) {
                const double xi = (j - 4) / 4.0;
                body.positions.push_back(10.0 * j);
                body.radii.emplace_back(K, 15 + 0.004 * (cone ? xi / 2 : -xi * xi));
            }
            const auto shapes = body.shapes();
            QVERIFY(within(minimumZoneCylinder(shapes, Directions(K)).deviation(), 0.004, 1e-12));
            QVERIFY(within(leastSquaresCylinder(shapes, Directions(K)).deviation(), 0.004, 1e-12));
        }
    }

    void sectionsAllAlikeAreAsCylindricalAsRound() {
        QVERIFY(holds("prism", [] {
            const std::size_t K = std::size_t(2 * pick(2, 20));
            const Body body = prism({5, 30, 80}, anyBody(1, K, decades(-4, -1.5)).radii[0]);
            const auto shapes = body.shapes();
            const Directions directions(K);
            const double roundness = minimumZoneCircles(body.radii[0], directions).deviation();
            const double zone = minimumZoneCylinder(shapes, directions).deviation();
            RC_ASSERT(zone <= roundness + 1e-12);
            // leaning gains at most R·t²/2, with t the lean that the form's width allows over 75 mm
            RC_ASSERT(zone >= roundness - 15 * std::pow(roundness / 37, 2) - 1e-12);
        }));
    }

    void oneSectionIsItsCircle() {
        const Body body = anyBodyOnce(1, 24);
        const auto shapes = body.shapes();
        const Directions directions(24);
        QCOMPARE(minimumZoneCylinder(shapes, directions).deviation(),
                 minimumZoneCircles(body.radii[0], directions).deviation());
        QCOMPARE(leastSquaresCylinder(shapes, directions).deviation(),
                 leastSquaresCircle(body.radii[0], directions).deviation());
        QCOMPARE(minimumZoneCylinder(shapes, directions).contacts.size(), std::size_t(4));
    }

    /// Of one section as of many: a point that touches stands on the cylinder it is told to touch.
    void aSingleSectionsContactsLieOnTheirOwnSide() {
        for (int i = 0; i < 20; ++i) {
            const Body body = anyBodyOnce(1, std::size_t(8 + 4 * i));
            const CylinderZone zone =
                minimumZoneCylinder(body.shapes(), Directions(body.radii[0].size()));
            QCOMPARE(zone.contacts.size(), std::size_t(4));
            const Axis axis{zone.x_mm, zone.y_mm, 0, 0};
            std::array<int, 2> bySide{};
            for (const CylinderContact& contact : zone.contacts) {
                const double d = distanceTo(body, 0, contact.radius, zone.position_mm, axis);
                QVERIFY(within(d, contact.outer ? zone.outer_mm : zone.inner_mm, 1e-11));
                ++bySide[contact.outer ? 1 : 0];
            }
            QCOMPARE(bySide, (std::array{2, 2}));
        }
    }

    // --- against brute force ---

    void linearProgrammeIsSolvedExactly() {
        QVERIFY(holds("sixes", [] {
            const std::size_t J = std::size_t(pick(2, 4)), K = J == 2 ? 6 : 4;
            Body body = anyBody(J, K, 0.01);
            if (oneIn(3)) { // many points that touch at once: the degenerate case
                body = prism(body.positions, body.radii[0]);
            }
            const AxisView view = linearView(body);
            ChebyshevFit fit(view, 0, J - 1);
            RC_ASSERT(within(fit.run(view, 1e-14).level, bestOfAllSixes(view), 1e-13));
        }));
    }

    void cylinderZoneIsTheBestOfAllAxes() {
        QVERIFY(holds("axes", [] {
            const std::size_t J = std::size_t(pick(2, 5)), K = std::size_t(2 * pick(2, 6));
            const double form = decades(-4, -2);
            const Body body = anyBody(J, K, form);
            const CylinderZone zone = minimumZoneCylinder(body.shapes(), Directions(K));
            const double reach = longest(body) / 2;
            const auto at = [&](const std::array<double, 4>& p) {
                return width(body, zone.position_mm, {p[0], p[1], p[2] / reach, p[3] / reach});
            };
            double best = 1e300;
            for (int start = 0; start < 4; ++start) {
                best = std::min(
                    best, fixtures::downhill<4>(at,
                                                {between(-1, 1) * form, between(-1, 1) * form,
                                                 between(-1, 1) * form, between(-1, 1) * form},
                                                form / 3));
            }
            const double w = zone.deviation();
            RC_ASSERT(w <= best + curvature(body, w));
            // and from the zone's own axis on no more is to be gained
            const double around = fixtures::downhill<4>(
                at, {zone.x_mm, zone.y_mm, zone.slopeX * reach, zone.slopeY * reach}, form / 100);
            RC_ASSERT(w <= around + curvature(body, w));
        }));
    }

    // --- what a zone is ---

    void cylindersHoldEveryPointAndTouchTheirContacts() {
        QVERIFY(holds("contacts", [] {
            const std::size_t J = std::size_t(pick(2, 6)), K = std::size_t(2 * pick(2, 18));
            const Body body = anyBody(J, K, decades(-3, -1));
            const CylinderZone zone = minimumZoneCylinder(body.shapes(), Directions(K));
            const Axis axis{zone.x_mm, zone.y_mm, zone.slopeX, zone.slopeY};
            const double digits = 1e-12;
            for (std::size_t j = 0; j < J; ++j) {
                for (std::size_t k = 0; k < K; ++k) {
                    const double d = distanceTo(body, j, k, zone.position_mm, axis);
                    RC_ASSERT(d <= zone.outer_mm + digits && d >= zone.inner_mm - digits);
                }
            }
            RC_ASSERT(!zone.contacts.empty() && zone.contacts.size() <= 6);
            for (const CylinderContact& contact : zone.contacts) {
                const double d =
                    distanceTo(body, contact.section, contact.radius, zone.position_mm, axis);
                RC_ASSERT(within(d, contact.outer ? zone.outer_mm : zone.inner_mm,
                                 curvature(body, zone.deviation())));
            }
        }));
    }

    void otherAxisHasNoLessSquares() {
        QVERIFY(holds("least", [] {
            const std::size_t J = std::size_t(pick(2, 6)), K = std::size_t(2 * pick(2, 18));
            const Body body = anyBody(J, K, decades(-3, -1));
            const CylinderZone zone = leastSquaresCylinder(body.shapes(), Directions(K));
            const auto squares = [&](const Axis& axis, double r) {
                double sum = 0;
                for (std::size_t j = 0; j < J; ++j) {
                    for (std::size_t k = 0; k < K; ++k) {
                        sum += std::pow(distanceTo(body, j, k, zone.position_mm, axis) - r, 2);
                    }
                }
                return sum;
            };
            const Axis axis{zone.x_mm, zone.y_mm, zone.slopeX, zone.slopeY};
            const double least = squares(axis, zone.reference_mm);
            const double step = decades(-5, -3);
            for (const double by : {-step, step}) {
                RC_ASSERT(
                    squares({axis.x + by, axis.y, axis.slopeX, axis.slopeY}, zone.reference_mm)
                    > least);
                RC_ASSERT(
                    squares({axis.x, axis.y + by, axis.slopeX, axis.slopeY}, zone.reference_mm)
                    > least);
                RC_ASSERT(
                    squares({axis.x, axis.y, axis.slopeX + by / 50, axis.slopeY}, zone.reference_mm)
                    > least);
                RC_ASSERT(
                    squares({axis.x, axis.y, axis.slopeX, axis.slopeY + by / 50}, zone.reference_mm)
                    > least);
                RC_ASSERT(squares(axis, zone.reference_mm + by) > least);
            }
        }));
    }

    void wildRadiiGetACylinderToo() {
        QVERIFY(holds("wild", [] {
            const std::size_t K = std::size_t(2 * pick(2, 12));
            Body body = anyBody(3, K, 1);
            for (Radii& radii : body.radii) {
                for (double& R : radii) {
                    R = between(1, 30);
                }
            }
            const CylinderZone zone = minimumZoneCylinder(body.shapes(), Directions(K));
            RC_ASSERT(std::isfinite(zone.deviation()) && zone.deviation() >= 0);
            RC_ASSERT(zone.deviation()
                      <= leastSquaresCylinder(body.shapes(), Directions(K)).deviation() + 1e-12);
        }));
    }

    // 200 sections of an elliptic shaft: thousands of points touch at once.
    void longShaftOfEqualEllipsesHasTheirZone() {
        const std::size_t K = 360;
        Radii ellipse(K);
        for (std::size_t k = 0; k < K; ++k) {
            ellipse[k] = 15 + 0.005 * std::cos(2 * angle(k, K));
        }
        std::vector<double> positions(200);
        std::iota(positions.begin(), positions.end(), 0.0);
        const Body body = prism(positions, ellipse);
        QVERIFY(within(minimumZoneCylinder(body.shapes(), Directions(K)).deviation(), 0.01, 1e-12));
    }

private:
    static Body anyBodyOnce(std::size_t J, std::size_t K) {
        Body body;
        for (std::size_t j = 0; j < J; ++j) {
            body.positions.push_back(10.0 * double(j));
            Radii radii(K);
            for (std::size_t k = 0; k < K; ++k) {
                radii[k] = 15 + 0.003 * std::sin(2.3 * double(k * k) + double(j));
            }
            body.radii.push_back(radii);
        }
        return body;
    }
};

} // namespace sparkout::test_cylindricity

SPARKOUT_TEST(test_cylindricity, TestCylindricity)
#include "test_cylindricity.moc"
