// SPDX-License-Identifier: GPL-3.0-or-later
// Total runout, the form along the length, and the harmonics of sections.
#include "tests/core/surface/ground_bodies.h"
#include "tests/registry.h"

namespace sparkout::test_form_along {

using namespace ground_bodies;

class TestFormAlong : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(200); }

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

    void runoutOfARunIsTheEngines() {
        Project p = fixtures::traverse();
        p.machine->geometric_runout_um = 1.5;
        const SimulationResult result = simulateUnchecked(p);
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
        addColumns<double, double, LongitudinalForm>("taper_um", "crown_um", "form");
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
};

} // namespace sparkout::test_form_along

SPARKOUT_TEST(test_form_along, TestFormAlong)
#include "test_form_along.moc"
