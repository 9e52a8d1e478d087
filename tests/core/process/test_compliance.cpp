// SPDX-License-Identifier: GPL-3.0-or-later
// The compliance of shafts whose numbers are published or have a closed form.
#include "core/process/compliance.h"

#include "core/process/system_compliance.h"
#include "tests/check_line.h"
#include "tests/core/process/shafts.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_compliance {

using namespace shafts;
using fixtures::close;

class TestCompliance : public QObject {
    Q_OBJECT

    HeldFunctions m_held;

private slots:
    void cleanup() { m_held.count(); }
    void cleanupTestCase() {
        m_held.print(
            "11",
            QStringLiteral(
                "closed forms and published numbers of compliance, to the tolerance beside each"));
    }

    void alongTheShaftTheTermsAreThoseOfEachPlace() {
        Project project = fixtures::steppedTraverse();
        const std::vector<CompliantPlace> along = complianceAlong(project, 41);
        QCOMPARE(along.size(), 41u);
        QCOMPARE(along.front().position_mm, -50.0);
        QCOMPARE(along.back().position_mm, 150.0);
        for (const CompliantPlace& place : along) {
            const double gamma =
                influenceRows(project, {place.position_mm}, {place.position_mm}).front();
            const ComplianceParts& p = place.parts;
            const double sum = p.wheelHead + p.headstock + p.tailstock + p.bending + p.rests;
            QVERIFY(close(sum, gamma, 1e-12));
            QVERIFY(p.rests <= 0);
        }
        // At the centres nothing bends and the other centre has no part.
        QCOMPARE(along.front().parts.bending, 0.0);
        QCOMPARE(along.front().parts.tailstock, 0.0);
        QVERIFY(std::abs(along.back().parts.headstock) < 1e-20);
        project.machine->compliance_mm_per_n = ZoneCompliance{1e-4, 1e-4, 1e-4};
        QVERIFY(complianceAlong(project, 41).empty());
    }

    // MODEL-6: γ of a section is the mean over what is ground, wherever on the shaft that lies; of
    // a zone it is that of the zone's middle.
    void aProjectsCompliancesAreThoseOfTheGroundPlaceOnItsShaft() {
        Project project = fixtures::plunge();
        project.sections = 3;
        project.machine->compliance_mm_per_n = std::monostate();
        project.machine->stiffness_n_um = Stiffness{60, 40, 50};
        project.part->shaft.segments = {{40, 25}, {120, 30}, {40, 20}};
        project.part->shaft.ground_from_mm = 110;
        ShaftModel model;
        model.segments = {{40, 25}, {120, 30}, {40, 20}};
        model.youngsModulus_n_mm2 = project.part->shaft.youngs_modulus_gpa * 1000;
        model.headstock_n_mm = 60e3;
        model.tailstock_n_mm = 40e3;
        model.wheelHead_n_mm = 50e3;
        const Compliance shaft(model);
        const double L = project.part->length_mm;
        const std::vector<CompliantPoint> sections = compliantPoints(project);
        for (std::size_t j = 0; j < 3; ++j) {
            const double x = L * (double(j) + 0.5) / 3;
            QVERIFY(close(sections[j].position_mm, x, 1e-14));
            QVERIFY(close(sections[j].gamma_mm_n, shaft.mean(110 + x, 110, 110 + L), 1e-12));
        }
        project.operation = Operation::traverse;
        project.wheel->width_mm = 12;
        project.machine->overrun_entry_mm = 2;
        project.machine->overrun_exit_mm = 5;
        const std::vector<CompliantPoint> zones = compliantPoints(project);
        const double middles[] = {5, 10 + (L - 17) / 2, L - 3.5};
        for (std::size_t zone = 0; zone < 3; ++zone) {
            QVERIFY(close(zones[zone].position_mm, middles[zone], 1e-14));
            QVERIFY(close(zones[zone].gamma_mm_n, shaft.at(110 + middles[zone]), 1e-12));
        }
    }

    // shared/vectors: shaft on centres
    void shaftOnCentresGivesThePublishedNumbers_data() {
        addColumns<double, double>("x", "gamma");
        QTest::newRow("headstock") << 0.0 << 1.00000e-5;
        QTest::newRow("first quarter") << 50.0 << 1.81029e-5;
        QTest::newRow("middle") << 100.0 << 2.74606e-5;
        QTest::newRow("last quarter") << 150.0 << 2.31029e-5;
        QTest::newRow("tailstock") << 200.0 << 2.00000e-5;
    }
    void shaftOnCentresGivesThePublishedNumbers() {
        QFETCH(double, x);
        QFETCH(double, gamma);
        const Compliance shaft(uniform(200, 30, Mounting::centres, 1e5, 0.5e5, rigid));
        QVERIFY(std::abs(shaft.at(x) - gamma) <= 0.5000001e-10);
    }

    // shared/vectors: the springs alone have their minimum 0.66667e-5 at 66.667 mm
    void springsAloneAreStiffestNearTheStiffCentre() {
        ShaftModel model = uniform(200, 30, Mounting::centres, 1e5, 0.5e5, rigid);
        model.youngsModulus_n_mm2 = rigid;
        const Compliance springs(model);
        QVERIFY(close(springs.at(200.0 / 3), 2e-5 / 3, 1e-12));
        QVERIFY(springs.at(66) > springs.at(200.0 / 3));
        QVERIFY(springs.at(67.3) > springs.at(200.0 / 3));
    }

    void uniformShaftEqualsTheClosedForm_data() {
        addColumns<bool, double, double, double>("centres", "jh", "jt", "jw");
        QTest::newRow("centres, all springs") << true << 6e4 << 4e4 << 5e4;
        QTest::newRow("centres, soft tailstock") << true << 1e6 << 1e3 << 5e4;
        QTest::newRow("centres, rigid") << true << rigid << rigid << rigid;
        QTest::newRow("chuck, all springs") << false << 6e4 << 4e4 << 5e4;
        QTest::newRow("chuck, rigid") << false << rigid << rigid << rigid;
    }
    void uniformShaftEqualsTheClosedForm() // model.md section 6
    {
        QFETCH(bool, centres);
        QFETCH(double, jh);
        QFETCH(double, jt);
        QFETCH(double, jw);
        const double L = 310;
        const double d = 34;
        const double EI = E * I(d);
        const Compliance shaft(
            uniform(L, d, centres ? Mounting::centres : Mounting::chuck, jh, jt, jw));
        for (double x = 0; x <= L; x += 15.5) {
            for (double s = x; s <= L; s += 15.5) {
                const double beam =
                    x * (L - s) * (L * L - x * x - (L - s) * (L - s)) / (6 * EI * L);
                const double expected = centres ? 1 / jw + (1 - x / L) * (1 - s / L) / jh
                                                      + (x / L) * (s / L) / jt + beam
                                                : 1 / jw + 1 / jh + x * x * (3 * s - x) / (6 * EI);
                QVERIFY2(close(shaft.between(x, s), expected, 1e-9),
                         qPrintable(QString("x %1, s %2").arg(x).arg(s)));
            }
        }
    }

    void rigidCentresLeaveTheBendingAtMidSpan() {
        const Compliance shaft(uniform(250, 40, Mounting::centres, rigid, rigid, 5e4));
        QVERIFY(close(shaft.at(125), 1 / 5e4 + 250.0 * 250 * 250 / (48 * E * I(40)), 1e-12));
        QCOMPARE(shaft.at(0), 1 / 5e4);
    }

    void chuckedShaftIgnoresTheTailstock() {
        const Compliance soft(uniform(120, 25, Mounting::chuck, 6e4, 1, 5e4));
        const Compliance none(uniform(120, 25, Mounting::chuck, 6e4, 0, 5e4));
        QCOMPARE(soft.between(40, 100), none.between(40, 100));
        QCOMPARE(none.partsAt(60).tailstock, 0.0);
        QCOMPARE(soft.at(0), 1 / 5e4 + 1 / 6e4);
    }

    void uniformShaftInManyPiecesIsOneShaft() {
        for (const Mounting mounting : {Mounting::centres, Mounting::chuck}) {
            ShaftModel pieces = uniform(200, 30, mounting, 6e4, 4e4, 5e4);
            pieces.rests = {{70, 3e4}, {130, 8e4}};
            const Compliance whole(pieces);
            pieces.segments.assign(64, {200.0 / 64, 30});
            const Compliance cut(pieces);
            for (double x = 0; x <= 200; x += 12.5) {
                for (double s = 0; s <= 200; s += 7.7)
                    QVERIFY(close(cut.between(x, s), whole.between(x, s), 1e-12));
                QVERIFY(close(cut.mean(x, 33, 171), whole.mean(x, 33, 171), 1e-12));
            }
        }
    }

    // Tip of a cantilever with d1 up to the step and d2 over the last a: (L^3 - a^3)/(3 E I1) +
    // a^3/(3 E I2)
    void cantileverOfTwoDiametersEqualsTheClosedForm() {
        const double a = 45;
        const double L = 125;
        const Compliance shaft(
            {{{L - a, 40}, {a, 22}}, E, Mounting::chuck, rigid, rigid, rigid, {}});
        QVERIFY(close(shaft.at(L),
                      (L * L * L - a * a * a) / (3 * E * I(40)) + a * a * a / (3 * E * I(22)),
                      1e-12));
    }

    // Force at the step of a shaft on two rigid centres: a^2 b^2/(3 E L^2) (a/I1 + b/I2)
    void steppedShaftOnCentresEqualsTheClosedForm() {
        const double a = 60;
        const double b = 92;
        const double L = a + b;
        const Compliance shaft({{{a, 28}, {b, 36}}, E, Mounting::centres, rigid, rigid, rigid, {}});
        QVERIFY(
            close(shaft.at(a), a * a * b * b / (3 * E * L * L) * (a / I(28) + b / I(36)), 1e-12));
    }

    void equalCentresAreSymmetricAboutTheMiddle() {
        const Compliance shaft({{{40, 20}, {70, 35}, {70, 35}, {40, 20}},
                                E,
                                Mounting::centres,
                                6e4,
                                6e4,
                                5e4,
                                {{60, 2e4}, {160, 2e4}}});
        for (double x = 0; x <= 110; x += 5) {
            QVERIFY(close(shaft.at(x), shaft.at(220 - x), 1e-12));
            QVERIFY(close(shaft.between(x, 150), shaft.between(220 - x, 70), 1e-12));
            QVERIFY(close(shaft.mean(x, 50, 100), shaft.mean(220 - x, 120, 170), 1e-12));
        }
    }

    // Even load 1/L over the whole shaft bends it by x (L^3 - 2 L x^2 + x^3)/(24 E I L) on centres
    // and by x^2 (6 L^2 - 4 L x + x^2)/(24 E I L) in a chuck
    void meanOverTheWholeShaftEqualsTheEvenlyLoadedBeam() {
        const double L = 180;
        const double EI = E * I(26);
        const Compliance centres(uniform(L, 26, Mounting::centres, 6e4, 4e4, 5e4));
        const Compliance chuck(uniform(L, 26, Mounting::chuck, 6e4, 4e4, 5e4));
        for (double x = 0; x <= L; x += 4.5) {
            const double u = x / L;
            const double springs = 1 / 5e4 + (1 - u) / 2 / 6e4 + u / 2 / 4e4;
            QVERIFY(close(centres.mean(x, 0, L),
                          springs + x * (L * L * L - 2 * L * x * x + x * x * x) / (24 * EI * L),
                          1e-12));
            QVERIFY(
                close(chuck.mean(x, 0, L),
                      1 / 5e4 + 1 / 6e4 + x * x * (6 * L * L - 4 * L * x + x * x) / (24 * EI * L),
                      1e-12));
        }
    }

    void stiffRestHoldsItsPoint() {
        ShaftModel model = uniform(300, 20, Mounting::centres, 6e4, 4e4, 5e4);
        const double free = Compliance(model).at(110) - 1 / 5e4;
        for (const double k : {1e4, 1e6, 1e8, 1e10}) {
            model.rests = {{110, k}};
            QVERIFY(close(Compliance(model).at(110), 1 / 5e4 + free / (1 + k * free), 1e-12));
        }
        QVERIFY(close(Compliance(model).at(110), 1 / 5e4 + 1 / 1e10, 1e-9));
        model.rests = {{110, rigid}, {110, rigid}};
        const Compliance held(model);
        for (const double x : {0.0, 55.0, 110.0, 300.0}) {
            QVERIFY(close(held.between(x, 110), 1 / 5e4, 1e-12));
            QVERIFY(std::isfinite(held.at(x)));
        }
    }

    // A cantilever propped rigidly at its tip, force in the middle: 7 L^3/(768 E I)
    void proppedCantileverEqualsTheClosedForm() {
        ShaftModel model = uniform(160, 24, Mounting::chuck, rigid, rigid, rigid);
        model.rests = {{160, rigid}};
        QVERIFY(close(Compliance(model).at(80), 7 * 160.0 * 160 * 160 / (768 * E * I(24)), 1e-12));
    }

    void softRestChangesNothing_data() {
        QTest::addColumn<double>("k");
        QTest::newRow("no stiffness") << 0.0;
        QTest::newRow("hardly any") << 1e-9;
    }
    void softRestChangesNothing() {
        QFETCH(double, k);
        ShaftModel model = uniform(300, 20, Mounting::centres, 6e4, 4e4, 5e4);
        const Compliance without(model);
        model.rests = {{110, k}};
        const Compliance with(model);
        for (double x = 0; x <= 300; x += 10) {
            QVERIFY(close(with.between(x, 140), without.between(x, 140), 1e-12));
            QVERIFY(close(with.mean(x, 20, 140), without.mean(x, 20, 140), 1e-12));
        }
    }

    void rigidRestAtARigidCentreAddsNothing() {
        ShaftModel model = uniform(300, 20, Mounting::centres, rigid, rigid, 5e4);
        const Compliance without(model);
        model.rests = {{0, rigid}, {300, 1e5}};
        const Compliance with(model);
        for (double x = 0; x <= 300; x += 10)
            QVERIFY(close(with.at(x), without.at(x), 1e-12));
    }

    void orderOfTheRestsDoesNotMatter() {
        ShaftModel model = uniform(300, 20, Mounting::centres, 6e4, 4e4, 5e4);
        model.rests = {{70, 3e4}, {150, 9e4}, {220, 1e5}};
        const Compliance forward(model);
        std::reverse(model.rests.begin(), model.rests.end());
        const Compliance backward(model);
        for (double x = 0; x <= 300; x += 10)
            QVERIFY(close(forward.between(x, 111), backward.between(x, 111), 1e-11));
    }

    void roundingOfASumOfLengthsStaysOnTheShaft() {
        const Compliance shaft({{{0.1, 20}, {0.2, 20}}, E, Mounting::centres, 6e4, 4e4, 5e4, {}});
        QVERIFY(shaft.length() > 0.3); // by one bit
        QCOMPARE(shaft.at(shaft.length() * (1 + 1e-12)), shaft.at(shaft.length()));
        QCOMPARE(shaft.at(-1e-15), shaft.at(0));
        QCOMPARE(shaft.mean(0.1, 0, 0.3), shaft.mean(0.1, 0, shaft.length()));
    }

    // One term at a time: 80^3/(3 * 2.1e5 * pi 25^4/64) = 4.238376e-5
    void quillAddsItsBendingToTheHeads() {
        QVERIFY(std::abs(quillCompliance(80, 25, E, rigid, rigid) - 4.238376e-5) < 1e-11);
        QVERIFY(close(quillCompliance(160, 25, E, rigid, rigid),
                      8 * quillCompliance(80, 25, E, rigid, rigid), 1e-12));
        QVERIFY(close(quillCompliance(80, 50, E, rigid, rigid),
                      quillCompliance(80, 25, E, rigid, rigid) / 16, 1e-12));
        QCOMPARE(quillCompliance(80, 25, rigid, 5e4, 6e4), 1 / 5e4 + 1 / 6e4);
    }

    void quillBendsLikeAChuckedShaftAtItsEnd() {
        const Compliance cantilever(uniform(80, 25, Mounting::chuck, 6e4, rigid, 5e4));
        QVERIFY(close(quillCompliance(80, 25, E, 5e4, 6e4), cantilever.at(80), 1e-12));
    }
};

} // namespace sparkout::test_compliance

SPARKOUT_TEST(test_compliance, TestCompliance)
#include "test_compliance.moc"
