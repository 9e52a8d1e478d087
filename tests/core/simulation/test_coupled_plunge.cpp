// SPDX-License-Identifier: GPL-3.0-or-later
// The plunge cycle with coupled sections [MODEL-6].
#include "core/process/compliance.h"
#include "core/process/system_compliance.h"
#include "core/project/validate.h"

#include "tests/core/support/allocation_counter.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

namespace sparkout::test_coupled_plunge {

using fixtures::close;
using fixtures::plungeStage;
using fixtures::slender;
using fixtures::sparkStage;
using fixtures::Traced;
using fixtures::within;

/// G of such a project at places along the ground length.
double influence(const Project& p, double x, double s) {
    ShaftModel model;
    for (const ShaftSegment& segment : p.part->shaft.segments) {
        model.segments.push_back({segment.length_mm, segment.diameter_mm});
    }
    model.youngsModulus_n_mm2 = p.part->shaft.youngs_modulus_gpa * 1e3;
    model.headstock_n_mm = p.machine->stiffness_n_um->headstock * 1e3;
    model.tailstock_n_mm = p.machine->stiffness_n_um->tailstock * 1e3;
    model.wheelHead_n_mm = p.machine->stiffness_n_um->wheel_head * 1e3;
    const double from = p.part->shaft.ground_from_mm;
    return Compliance(model).between(from + x, from + s);
}

double middle(const Project& p, int j) {
    return p.part->length_mm * (j + 0.5) / p.sections;
}

/// Radii are solved one by one, and side by side.
void someSections(int few, int more) {
    QTest::addColumn<int>("sections");
    QTest::newRow("one by one") << few;
    QTest::newRow("side by side") << more;
}

/// The passes of a revolution stand next to each other, from the headstock on.
const Visit& visitOf(const Traced& run, int revolution, int section, int k) {
    const int sections = run.result.project.sections;
    return run.visit(run.trajectory.passes[std::size_t(revolution * sections + section)], k);
}

class TestCoupledPlunge : public QObject {
    Q_OBJECT

private slots:
    void everyRevolutionSatisfiesTheConditions_data() {
        addColumns<int, double, bool>("sections", "dullness", "bore");
        QTest::newRow("usual") << 4 << 0.02 << false;
        QTest::newRow("many sections") << 25 << 0.02 << false;
        QTest::newRow("sharp") << 6 << 0.0 << false;
        QTest::newRow("dull") << 8 << 0.2 << false;
        QTest::newRow("bore") << 5 << 0.02 << true;
        // From eight sections on radii are solved side by side.
        QTest::newRow("sharp, side by side") << 10 << 0.0 << false;
        QTest::newRow("bore, side by side") << 9 << 0.02 << true;
        QTest::newRow("contact is lost and comes back") << 10 << 0.02 << false;
    }
    void everyRevolutionSatisfiesTheConditions() {
        QFETCH(int, sections);
        QFETCH(double, dullness);
        QFETCH(bool, bore);
        Project p = slender(sections);
        p.wheel->dullness = dullness;
        p.cycle->stages = {plungeStage(0.9, 0.15), plungeStage(0.2, 0.05),
                           sparkStage(fixtures::count(20))};
        const bool losesContact = sections == 10 && dullness > 0;
        if (losesContact) {
            p.cycle->stages = {plungeStage(0.9, 0.1), plungeStage(-60, 0.08),
                               plungeStage(0.3, 0.02)};
        }
        if (bore) {
            p.part->surface = Surface::internal;
            p.wheel->diameter_mm = 20;
            p.part->shaft.quill = Quill{50, 16};
        }
        QVERIFY(!hasErrors(validate(p)));
        const Traced run(p);
        QCOMPARE(run.result.status, RunStatus::completed);
        const fixtures::Law law(p);
        const double quill =
            1 / 50e3 + 1 / 40e3
            + 50.0 * 50 * 50 / (3 * 210e3 * std::numbers::pi * 16 * 16 * 16 * 16 / 64);
        std::vector<double> G;
        for (int j = 0; j < sections * sections; ++j) {
            G.push_back(bore ? quill
                             : influence(p, middle(p, j / sections), middle(p, j % sections)));
        }
        const std::vector<double> blank = fixtures::blankDepths(p);
        const double slice = p.part->length_mm / sections;
        const int revolutions = run.result.cycleCount;
        int cutting = 0, idleLast = 0;
        for (int m = 0; m < revolutions; ++m) {
            const int cutBefore = cutting;
            for (int k = 0; k < p.part->radii_per_section; ++k) {
                for (int j = 0; j < sections; ++j) {
                    const Visit& v = visitOf(run, m, j, k);
                    double rest = v.actual_mm;
                    for (int l = 0; l < sections; ++l) {
                        rest += G[std::size_t(j * sections + l)]
                                * law.force(slice, visitOf(run, m, l, k).actual_mm);
                    }
                    const double before = v.accumulated_mm - v.actual_mm;
                    rest -= v.programmed_mm - before - blank[std::size_t(k)];
                    QVERIFY(v.actual_mm >= 0);
                    QVERIFY(rest > -1e-12);
                    QVERIFY(v.actual_mm == 0 || rest < 1e-12);
                    QVERIFY(
                        close(v.normalForce_n, law.force(p.part->length_mm, v.actual_mm), 1e-12));
                    cutting += v.actual_mm > 0;
                }
            }
            idleLast = cutting == cutBefore ? m : idleLast;
        }
        QVERIFY(cutting > revolutions * sections);
        QVERIFY(!losesContact || (idleLast > 10 && idleLast < revolutions - 10));
    }

    // J = 1: G(x,x) at the middle is the one compliance there is.
    void oneSectionIsTheIndependentModel() {
        const Project coupled = slender(1);
        Project independent = coupled;
        independent.sections_coupled = false;
        independent.machine->compliance_mm_per_n = std::vector<double>{influence(coupled, 20, 20)};
        const SimulationResult one = simulateUnchecked(coupled),
                               two = simulateUnchecked(independent);
        QCOMPARE(one.countsByStage, two.countsByStage);
        for (std::size_t k = 0; k < 12; ++k) {
            QVERIFY(within(one.sections[0].radii_mm[k], two.sections[0].radii_mm[k], 1e-12));
        }
        QVERIFY(close(one.peakNormalForce_n, two.peakNormalForce_n, 1e-9));
        QVERIFY(close(one.peakPower_w, two.peakPower_w, 1e-9));
    }

    // Only the wheel head yields: every section stands the same and cuts as if it were alone, with
    // the whole width on γ = 1/j_w.
    void rigidShaftOnASoftWheelHeadIsTheIndependentModel() {
        Project coupled = slender(6);
        coupled.machine->stiffness_n_um = Stiffness{1e6, 1e6, 10};
        coupled.part->shaft.segments = {{190, 1000}};
        coupled.part->shaft.youngs_modulus_gpa = 1000;
        Project independent = coupled;
        independent.sections_coupled = false;
        const SimulationResult one = simulateUnchecked(coupled),
                               two = simulateUnchecked(independent);
        QCOMPARE(one.countsByStage, two.countsByStage);
        for (std::size_t j = 0; j < 6; ++j) {
            for (std::size_t k = 0; k < 12; ++k) { // the rigid shaft's centres still give 1 nm/N
                QVERIFY(within(one.sections[j].radii_mm[k], two.sections[j].radii_mm[k], 2e-6));
            }
        }
    }

    void peakForceAndPowerAreIntegralsOverTheLength() {
        Project p = slender(7);
        p.cycle->stages = {plungeStage(1.5, 0.17), plungeStage(0.3, 0.03)};
        const Traced run(p);
        const fixtures::Law law(p);
        double force = 0, power = 0;
        int at = 0;
        const double kt = law.ks / p.material->shear_factor * p.material->shear_strain;
        for (int m = 0; m < run.result.cycleCount; ++m) {
            for (int k = 0; k < 12; ++k) {
                double normal = 0, tangential = 0;
                for (int j = 0; j < 7; ++j) {
                    const double a = visitOf(run, m, j, k).actual_mm;
                    normal += law.force(40.0 / 7, a);
                    tangential +=
                        40.0 / 7 * (kt * a + p.material->friction * law.kr * std::sqrt(a));
                }
                if (normal > force) {
                    force = normal;
                    at = m + 1;
                }
                power = std::max(power, tangential * p.machine->wheel_speed_m_s);
            }
        }
        QVERIFY(close(run.result.peakNormalForce_n, force, 1e-12));
        QVERIFY(close(run.result.peakPower_w, power, 1e-12));
        QCOMPARE(run.result.peakNormalForceAt.cycleCount, at);
        QCOMPARE(run.result.peakNormalForceAt.stage, 1);
    }

    // More sections describe the same shaft: what they say of its middle converges.
    void moreSectionsConverge() {
        const auto force = [](int sections) {
            Project p = slender(sections);
            p.gauge->control = Control::position;
            p.part->initial_runout_mm = 0;
            return simulateUnchecked(p).peakNormalForce_n;
        };
        const double exact = force(81);
        const double coarse = std::abs(force(3) - exact);
        const double fine = std::abs(force(9) - exact);
        QVERIFY(coarse > 0);
        QVERIFY2(fine < coarse / 5, qPrintable(QStringLiteral("%1 %2").arg(coarse).arg(fine)));
    }

    void freeGaugeOnASectionReadsThatSection_data() { someSections(5, 9); }
    void freeGaugeOnASectionReadsThatSection() {
        QFETCH(int, sections);
        for (int j = 0; j < sections; ++j) {
            Project fixed = slender(sections);
            fixed.gauge->section = j;
            Project free = slender(sections);
            free.gauge->position_mm = middle(free, j);
            const SimulationResult one = simulateUnchecked(fixed), two = simulateUnchecked(free);
            QCOMPARE(one.countsByStage, two.countsByStage);
            QVERIFY(within(one.gaugeReading_mm, two.gaugeReading_mm, 1e-11));
            QCOMPARE(two.sections.size(), std::size_t(sections));
            QCOMPARE(one.sections[2].radii_mm, two.sections[2].radii_mm);
        }
    }

    // The gauge's own γ is how far its place yields under the force on the wheel.
    void gaugesOwnComplianceDecidesWhatItReads() {
        Project p = slender(5);
        p.gauge->position_mm = 3;
        p.gauge->control = Control::position; // the same cycle, read differently
        const auto reading = [&](double gamma) {
            p.gauge->compliance_mm_per_n = gamma;
            return simulateUnchecked(p).gaugeReading_mm;
        };
        const double rigid = reading(1e-15);
        QVERIFY(reading(3e-5) > rigid);
        QVERIFY(reading(6e-5) > reading(3e-5));
        // Without deflection radius k stands where the wheel head was fed to at (k+1)/K: the
        // smallest diameter is that of the last radius, half a revolution of 5 µm before it the
        // other end.
        QVERIFY(within(rigid / 2, targetRadius(*p.part) + 0.005 / 4, 1e-9));
    }

    void veryDullWheelOnVerySlowWorkKeepsTheDepths_data() { someSections(3, 9); }
    void veryDullWheelOnVerySlowWorkKeepsTheDepths() {
        QFETCH(int, sections);
        Project p = slender(sections);
        p.wheel->dullness = 1;
        p.machine->work_speed_rpm = 2;
        p.cycle->stages = {plungeStage(0.01, 0.2)};
        const fixtures::Law law(p);
        QVERIFY(law.kr > 500 * law.ks); // the pass takes its other form of the root
        const Traced run(p);
        QCOMPARE(run.result.status, RunStatus::completed);
        for (int m = 0; m < run.result.cycleCount; ++m) {
            const Visit& v = visitOf(run, m, 1, 5);
            double rest = v.actual_mm;
            for (int l = 0; l < sections; ++l) {
                rest += influence(p, middle(p, 1), middle(p, l))
                        * law.force(40.0 / sections, visitOf(run, m, l, 5).actual_mm);
            }
            rest -=
                v.programmed_mm - (v.accumulated_mm - v.actual_mm) - fixtures::blankDepths(p)[5];
            QVERIFY(v.actual_mm == 0 ? rest > -1e-12 : std::abs(rest) < 1e-12);
        }
    }

    void traceChangesNothing() {
        Project p = slender(4);
        p.gauge->position_mm = 11;
        QVERIFY(fixtures::sameBits(simulateUnchecked(p), Traced(p).result));
        QVERIFY(fixtures::sameBits(simulateUnchecked(p), simulateUnchecked(p)));
    }

    void plainRunAllocatesNothingPerRevolution_data() { someSections(4, 9); }
    void plainRunAllocatesNothingPerRevolution() {
        QFETCH(int, sections);
        const auto allocationsOf = [sections](int sparking) {
            Project p = slender(sections);
            p.gauge->position_mm = 10;
            p.cycle->stages.push_back(sparkStage(fixtures::count(sparking)));
            const long long before = allocations::count;
            const SimulationResult r = simulateUnchecked(p);
            return r.status != RunStatus::completed ? -1 : allocations::count - before;
        };
        QCOMPARE(allocationsOf(500), allocationsOf(5));
    }

    void sparkOutThatStallsEndsWithTheSizeReached() {
        Project p = slender(4);
        p.gauge->control = Control::position;
        p.wheel->dullness = 0;
        p.part->stock_mm += 0.004;
        p.cycle->stages.push_back(sparkStage(fixtures::untilSize(), 0.004));
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.status, RunStatus::cannotReachSize);
        QVERIFY(within(r.remainingStock_mm, 0.004, 1e-9));
    }

    // A thin neck, and a rest in the ground length: the even load beyond the rest swings the
    // section this side of it towards the wheel. It has no balance of its own; coupled, it is left
    // uncut until the others are, and the part is finished.
    void sectionsThatTheEvenLoadLiftsNeedTheCoupling() {
        Project p = slender(4, false);
        p.part->shaft.mounting = Mounting::chuck;
        p.part->shaft.segments = {{60, 4}, {80, 40}};
        p.part->shaft.ground_from_mm = 60;
        p.part->shaft.steady_rests = {{70, 200}};
        QVERIFY(!hasErrors(validate(p)));
        QVERIFY(compliantPoints(p).front().gamma_mm_n < 0);
        QVERIFY(compliantPoints(p).back().gamma_mm_n > 0);
        const SimulationResult alone = simulateUnchecked(p);
        QCOMPARE(alone.status, RunStatus::notSolved);
        QCOMPARE(alone.cycleCount, 0);
        for (const SectionResult& section : alone.sections) {
            for (const double radius : section.radii_mm) {
                QVERIFY(std::isfinite(radius));
            }
        }
        p.sections_coupled = true;
        QVERIFY(simulateUnchecked(p).status != RunStatus::notSolved);
    }

    void stopIsHeededWithinARevolution() {
        const StoppedSource source;
        QCOMPARE(simulateUnchecked(slender(4), nullptr, source.get_token()).status,
                 RunStatus::stopped);
    }

    // Given compliances do not say how the sections move each other.
    void givenCompliancesAreRefused() {
        Project p = fixtures::plunge();
        QVERIFY(!hasErrors(validate(p)));
        p.sections_coupled = true;
        const Issues issues = validate(p);
        const auto found = std::ranges::find(issues, "/sections_coupled", &Issue::path);
        QVERIFY(found != issues.end());
        QCOMPARE(found->code, IssueCode::influenceUnknown);
        QCOMPARE(found->severity, Severity::error);
        QVERIFY(!hasErrors(validate(slender(4))));
        for (const Issue& issue : validate(slender(4))) {
            QVERIFY(issue.path != "/sections_coupled"); // nothing is left out any more
        }
        Project traverse = fixtures::traverse();
        traverse.sections_coupled = true; // not read there
        QVERIFY(!hasErrors(validate(traverse)));
    }
};

} // namespace sparkout::test_coupled_plunge

SPARKOUT_TEST(test_coupled_plunge, TestCoupledPlunge)
#include "test_coupled_plunge.moc"
