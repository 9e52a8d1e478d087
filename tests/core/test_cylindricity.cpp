// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/cylindricity.h"

#include "core/quality/accuracy.h"
#include "core/quality/chebyshev_fit.h"
#include "core/quality/harmonics.h"
#include "tests/core/dense.h"
#include "tests/core/downhill.h"
#include "tests/core/random_cutting.h"
#include "tests/core/rapidcheck_runs.h"
#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

namespace test_cylindricity {

using namespace sparkout;
using fixtures::between;
using fixtures::close;
using fixtures::decades;
using fixtures::oneIn;
using fixtures::pick;
using fixtures::within;

namespace {

using Radii = std::vector<double>;

bool holds(const char* law, const std::function<void()>& check) {
    return rc::check(law, check);
}

double angle(std::size_t k, std::size_t K) {
    return 2 * std::numbers::pi * double(k) / double(K);
}

/// The sections of a part, which own their radii.
struct Body {
    std::vector<double> positions;
    std::vector<Radii> radii;

    [[nodiscard]] std::vector<SectionShape> shapes() const {
        std::vector<SectionShape> found;
        for (std::size_t j = 0; j < positions.size(); ++j) {
            found.push_back({positions[j], radii[j]});
        }
        return found;
    }
    [[nodiscard]] std::size_t K() const { return radii[0].size(); }
};

Body anyBody(std::size_t J, std::size_t K, double form) {
    Body body;
    double position = between(0, 20);
    for (std::size_t j = 0; j < J; ++j) {
        body.positions.push_back(position);
        position += between(2, 60);
        Radii radii(K);
        const double shift = form * between(0, 0.4), phase = between(0, 6);
        const double size = form * between(-0.3, 0.3), lobe = form * between(0, 0.3);
        for (std::size_t k = 0; k < K; ++k) {
            radii[k] = 15 + size + shift * std::cos(angle(k, K) - phase)
                       + lobe * std::cos(3 * angle(k, K)) + 0.2 * form * between(-1, 1);
        }
        body.radii.push_back(radii);
    }
    return body;
}

/// Every section alike.
Body prism(const std::vector<double>& positions, const Radii& radii) {
    return {positions, std::vector<Radii>(positions.size(), radii)};
}

struct Axis {
    double x = 0, y = 0, slopeX = 0, slopeY = 0;
};

/// Distance of a point to a line through (x, y) at `middle`, by the cross product.
double distanceTo(const Body& body, std::size_t j, std::size_t k, double middle, const Axis& axis) {
    const double x = body.radii[j][k] * std::cos(angle(k, body.K())) - axis.x;
    const double y = body.radii[j][k] * std::sin(angle(k, body.K())) - axis.y;
    const double z = body.positions[j] - middle;
    const double u = axis.slopeX, v = axis.slopeY;
    return std::hypot(y - z * v, z * u - x, x * v - y * u) / std::hypot(u, v, 1);
}

double width(const Body& body, double middle, const Axis& axis) {
    double low = 1e300, high = 0;
    for (std::size_t j = 0; j < body.positions.size(); ++j) {
        for (std::size_t k = 0; k < body.K(); ++k) {
            const double d = distanceTo(body, j, k, middle, axis);
            low = std::min(low, d);
            high = std::max(high, d);
        }
    }
    return high - low;
}

/// The radii at which rays from the axis of the machine meet a true cylinder that leans.
Body leaningCylinder(const std::vector<double>& positions, std::size_t K, double R,
                     const Axis& axis) {
    Body body{positions, {}};
    const double t2 = axis.slopeX * axis.slopeX + axis.slopeY * axis.slopeY;
    for (const double z : positions) {
        Radii radii(K);
        for (std::size_t k = 0; k < K; ++k) {
            const double c = std::cos(angle(k, K)), s = std::sin(angle(k, K));
            const double ax = axis.x + axis.slopeX * z, ay = axis.y + axis.slopeY * z;
            // |q|² − (q·t)²/(1 + t²) = R² with q = ρ·(c, s) − a, a quadratic in ρ
            const double ct = c * axis.slopeX + s * axis.slopeY;
            const double at = ax * axis.slopeX + ay * axis.slopeY;
            const double A = 1 - ct * ct / (1 + t2);
            const double B = -(c * ax + s * ay) + ct * at / (1 + t2);
            const double C = ax * ax + ay * ay - at * at / (1 + t2) - R * R;
            radii[k] = (-B + std::sqrt(B * B - A * C)) / A;
        }
        body.radii.push_back(radii);
    }
    return body;
}

/// The surface's points as an axis in the middle sees them, all linear.
AxisSight linearSight(const Body& body) {
    AxisSight sight(body.positions.size(), body.K());
    const double middle = (body.positions.front() + body.positions.back()) / 2;
    const double reach = (body.positions.back() - body.positions.front()) / 2;
    for (std::size_t j = 0; j < body.positions.size(); ++j) {
        for (std::size_t k = 0; k < body.K(); ++k) {
            const std::size_t i = j * body.K() + k;
            sight.d[i] = body.radii[j][k];
            sight.nx[i] = std::cos(angle(k, body.K()));
            sight.ny[i] = std::sin(angle(k, body.K()));
        }
        sight.zeta[j] = (body.positions[j] - middle) / reach;
    }
    return sight;
}

/// The largest level of any six points: by duality the least of the whole.
double bestOfAllSixes(const AxisSight& sight) {
    const std::size_t N = sight.d.size();
    double most = 0;
    std::vector<bool> chosen(N);
    std::fill(chosen.begin(), chosen.begin() + 6, true);
    do {
        dense::Matrix G(5);
        std::vector<double> d;
        for (std::size_t i = 0; i < N; ++i) {
            if (chosen[i]) {
                G[0].push_back(1);
                G[1].push_back(sight.nx[i]);
                G[2].push_back(sight.ny[i]);
                G[3].push_back(sight.nx[i] * sight.zetaOf(i));
                G[4].push_back(sight.ny[i] * sight.zetaOf(i));
                d.push_back(sight.d[i]);
            }
        }
        most = std::max(most, dense::alternation(G, d));
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    return most;
}

double longest(const Body& body) {
    return body.positions.back() - body.positions.front();
}

/// What the curvature of the distances may hide (the header's bound), and some last bits.
double curvature(const Body& body, double w) {
    return 2 * (w * w / 15 + 15 * std::pow(2 * w / longest(body), 2)) + 2e-12;
}

} // namespace

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

    // --- against brute force ---

    void linearProgrammeIsSolvedExactly() {
        QVERIFY(holds("sixes", [] {
            const std::size_t J = std::size_t(pick(2, 4)), K = J == 2 ? 6 : 4;
            Body body = anyBody(J, K, 0.01);
            if (oneIn(3)) { // many points that touch at once: the degenerate case
                body = prism(body.positions, body.radii[0]);
            }
            const AxisSight sight = linearSight(body);
            ChebyshevFit fit(sight, 0, J - 1);
            RC_ASSERT(within(fit.run(sight, 1e-14).level, bestOfAllSixes(sight), 1e-13));
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

    void minimumZoneIsBetweenTheWorstSectionAndTheLeastSquares() {
        QVERIFY(holds("order", [] {
            const std::size_t J = std::size_t(pick(2, 6)), K = std::size_t(2 * pick(2, 18));
            const double form = decades(-4, -2);
            const Body body = anyBody(J, K, form);
            const auto shapes = body.shapes();
            const Directions directions(K);
            const CylinderZone zone = minimumZoneCylinder(shapes, directions);
            RC_ASSERT(zone.deviation()
                      <= leastSquaresCylinder(shapes, directions).deviation() + 1e-14);
            const double lean = std::hypot(zone.slopeX, zone.slopeY);
            for (const Radii& radii : body.radii) {
                const double roundness = minimumZoneCircles(radii, directions).deviation();
                RC_ASSERT(zone.deviation() >= roundness - 8 * lean * lean - 1e-12);
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

    void partTurnedEndForEndIsTheSame() {
        QVERIFY(holds("end for end", [] {
            const std::size_t K = std::size_t(2 * pick(2, 12));
            const Body body = anyBody(4, K, decades(-3, -1));
            Body turned = body;
            std::reverse(turned.radii.begin(), turned.radii.end());
            for (std::size_t j = 0; j < 4; ++j) {
                turned.positions[j] = 500 - body.positions[3 - j];
            }
            const Directions directions(K);
            const double w = minimumZoneCylinder(body.shapes(), directions).deviation();
            RC_ASSERT(within(minimumZoneCylinder(turned.shapes(), directions).deviation(), w,
                             curvature(body, w)));
            RC_ASSERT(within(leastSquaresCylinder(turned.shapes(), directions).deviation(),
                             leastSquaresCylinder(body.shapes(), directions).deviation(), 4e-12));
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

    // --- runout ---

    void totalRunoutSpansAllSectionsAndAddsTheMachines() {
        const Body body{{10, 60}, {{15.001, 15, 15.002, 15}, {14.998, 15, 15, 14.999}}};
        const auto shapes = body.shapes();
        const PartAccuracy part = partAccuracy(shapes, 0.0015);
        QVERIFY(within(part.totalRunout_mm, 0.004 + 0.0015, 1e-14));
        QVERIFY(within(part.sections[0].radialRunout_mm, 0.002 + 0.0015, 1e-14));
        QVERIFY(within(part.sections[1].radialRunout_mm, 0.002 + 0.0015, 1e-14));
        const PartAccuracy alone = partAccuracy(shapes, 0);
        QCOMPARE(part.minimumZone.deviation(), alone.minimumZone.deviation());
        QCOMPARE(part.sections[0].minimumZone.deviation(),
                 alone.sections[0].minimumZone.deviation());
    }

    // ISO 1101: total runout is never below cylindricity, nor a section's runout below its
    // roundness.
    void runoutIsNeverBelowTheForm() {
        QVERIFY(holds("runout", [] {
            const std::size_t J = std::size_t(pick(1, 6)), K = std::size_t(2 * pick(2, 18));
            const Body body = anyBody(J, K, decades(-4, -1));
            const PartAccuracy part = partAccuracy(body.shapes(), 0);
            RC_ASSERT(part.totalRunout_mm >= part.minimumZone.deviation() - 1e-13);
            for (const SectionAccuracy& section : part.sections) {
                RC_ASSERT(section.radialRunout_mm >= section.minimumZone.deviation() - 1e-13);
                RC_ASSERT(section.radialRunout_mm <= part.totalRunout_mm);
            }
        }));
    }

    // A section of a run: the engine's runout is this one.
    void runoutOfARunIsTheEngines() {
        Project p = fixtures::traverse();
        p.machine.geometric_runout_um = 1.5;
        const SimulationResult result = simulate(p);
        std::vector<SectionShape> shapes;
        for (const SectionResult& section : result.sections) {
            shapes.push_back({section.position_mm, section.radii_mm});
        }
        const PartAccuracy part = partAccuracy(shapes, 0.0015);
        for (std::size_t j = 0; j < shapes.size(); ++j) {
            QVERIFY(within(part.sections[j].radialRunout_mm, result.sections[j].radialRunout_mm,
                           1e-15));
        }
        QVERIFY(partAccuracy({}, 0).sections.empty());
    }

    // --- along the length ---

    void parabolaIsTakenApartExactly() {
        QVERIFY(holds("parabola", [] {
            const double taper = between(-0.02, 0.02), crown = between(-0.02, 0.02);
            const std::size_t J = std::size_t(pick(3, 12));
            std::vector<double> positions{between(0, 10)}, radii;
            for (std::size_t j = 1; j < J; ++j) {
                positions.push_back(positions.back() + between(1, 50));
            }
            const double middle = (positions.front() + positions.back()) / 2;
            const double reach = (positions.back() - positions.front()) / 2;
            for (const double x : positions) {
                const double xi = (x - middle) / reach;
                radii.push_back(15 + taper / 2 * xi - crown * xi * xi);
            }
            const LongitudinalProfile found = longitudinalProfile(positions, radii);
            RC_ASSERT(within(found.taper_mm, taper, 1e-10)); // close sections magnify the last bits
            RC_ASSERT(within(found.crown_mm, crown, 1e-10));
        }));
    }

    void profileIsTheLeastSquaresParabola() {
        QVERIFY(holds("least squares", [] {
            const int J = pick(4, 12);
            std::vector<double> positions, radii;
            dense::Matrix A;
            for (int j = 0; j < J; ++j) {
                positions.push_back(10 * j + between(0, 8));
                radii.push_back(15 + between(-0.01, 0.01));
            }
            const double middle = (positions.front() + positions.back()) / 2;
            const double reach = (positions.back() - positions.front()) / 2;
            for (int j = 0; j < J; ++j) {
                const double xi = (positions[std::size_t(j)] - middle) / reach;
                A.push_back({1, xi, xi * xi});
            }
            const std::vector<double> c = dense::leastSquares(A, radii);
            const LongitudinalProfile found = longitudinalProfile(positions, radii);
            RC_ASSERT(within(found.taper_mm, 2 * c[1], 1e-12));
            RC_ASSERT(within(found.crown_mm, -c[2], 1e-12));
        }));
    }

    void formIsNamedByItsLargerPart_data() {
        QTest::addColumn<double>("taper_um");
        QTest::addColumn<double>("crown_um");
        QTest::addColumn<LongitudinalForm>("form");
        QTest::newRow("straight") << 0.005 << -0.005 << LongitudinalForm::straight;
        QTest::newRow("taper up") << 3.0 << 1.0 << LongitudinalForm::taper;
        QTest::newRow("taper down") << -3.0 << 1.0 << LongitudinalForm::taper;
        QTest::newRow("barrel") << -1.0 << 3.0 << LongitudinalForm::barrel;
        QTest::newRow("saddle") << 1.0 << -3.0 << LongitudinalForm::saddle;
    }
    void formIsNamedByItsLargerPart() {
        QFETCH(double, taper_um);
        QFETCH(double, crown_um);
        QFETCH(LongitudinalForm, form);
        std::vector<double> positions, radii;
        for (int j = 0; j < 5; ++j) {
            const double xi = (j - 2) / 2.0;
            positions.push_back(20.0 * j);
            radii.push_back(15 + (taper_um / 2 * xi - crown_um * xi * xi) / 1000);
        }
        QVERIFY(longitudinalProfile(positions, radii).form == form);
    }

    void fewSectionsHaveFewParts() {
        const std::vector<double> positions{10, 90}, radii{15.004, 15.001};
        const LongitudinalProfile two = longitudinalProfile(positions, radii);
        QVERIFY(within(two.taper_mm, -0.003, 1e-14));
        QCOMPARE(two.crown_mm, 0.0);
        QVERIFY(two.form == LongitudinalForm::taper);
        const LongitudinalProfile one =
            longitudinalProfile(std::span(positions).first(1), std::span(radii).first(1));
        QCOMPARE(one.taper_mm, 0.0);
        QVERIFY(one.form == LongitudinalForm::straight);
    }

    // --- lobes ---

    void harmonicsComeBackAsTheyWentIn() {
        QVERIFY(holds("synthesis", [] {
            const int K = 2 * pick(2, 40);
            Radii radii(std::size_t(K), 15.0);
            std::vector<double> amplitudes{15}, phases{0};
            for (int n = 1; n <= K / 2; ++n) {
                const bool half = 2 * n == K;
                amplitudes.push_back(oneIn(3) ? 0 : between(1e-5, 0.01));
                phases.push_back(half ? 0 : between(-3, 3));
                for (int k = 0; k < K; ++k) {
                    radii[std::size_t(k)] +=
                        amplitudes.back()
                        * std::cos(n * angle(std::size_t(k), std::size_t(K)) - phases.back());
                }
            }
            const auto found = harmonics(radii, Directions(std::size_t(K)));
            RC_ASSERT(found.size() == amplitudes.size());
            for (std::size_t n = 0; n < found.size(); ++n) {
                RC_ASSERT(found[n].lobes == int(n));
                RC_ASSERT(within(found[n].amplitude_mm, amplitudes[n], 1e-13));
                RC_ASSERT(amplitudes[n] == 0 || within(found[n].phase_rad, phases[n], 1e-8));
            }
        }));
    }

    void harmonicsKeepTheSquaresAndGiveTheRadiiBack() {
        QVERIFY(holds("Parseval", [] {
            const std::size_t K = std::size_t(2 * pick(2, 60));
            const Radii radii = anyBody(1, K, 0.1).radii[0];
            const auto found = harmonics(radii, Directions(K));
            double squares = 0, parts = found[0].amplitude_mm * found[0].amplitude_mm;
            for (const double R : radii) {
                squares += R * R / double(K);
            }
            for (std::size_t n = 1; n < found.size(); ++n) {
                parts += found[n].amplitude_mm * found[n].amplitude_mm * (2 * n == K ? 1 : 0.5);
            }
            RC_ASSERT(close(squares, parts, 1e-13));
            for (std::size_t k = 0; k < K; ++k) {
                double R = 0;
                for (const Harmonic& h : found) {
                    R += h.amplitude_mm * std::cos(h.lobes * angle(k, K) - h.phase_rad);
                }
                RC_ASSERT(within(R, radii[k], 1e-12));
            }
        }));
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

} // namespace test_cylindricity

SPARKOUT_TEST(test_cylindricity, TestCylindricity)
#include "test_cylindricity.moc"
