// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a run beyond independent sections on a rigid wheel: the wheel's contact in series,
// in independent and in coupled sections, and the decay of a lobed blank.
#include "core/process/contact_compliance.h"
#include "core/process/system_compliance.h"
#include "core/simulation/plunge.h"
#include "core/simulation/traverse.h"
#include "core/surface/harmonics.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_run_options {

using fixtures::close;
using fixtures::plungeStage;
using fixtures::slender;
using fixtures::sparkStage;
using fixtures::Traced;
using fixtures::within;

const std::vector<std::vector<double>> rising{{10, 5}, {100, 20}, {400, 60}};

Project contacting(Project p, std::vector<std::vector<double>> rows = rising) {
    p.machine->wheel_contact = WheelContact{NumberRows{std::move(rows)}};
    return p;
}

/// Depth of a visit below first touch before it cut.
double depthBefore(const Project& p, const Visit& visit, int k) {
    return fixtures::blankDepths(p)[static_cast<std::size_t>(k)] + visit.accumulated_mm
           - visit.actual_mm;
}

double amplitude(const std::vector<double>& radii, int lobes) {
    return harmonics(radii, Directions(radii.size()))[static_cast<std::size_t>(lobes)].amplitude_mm;
}

class TestRunOptions : public QObject {
    Q_OBJECT

private slots:
    /// A search that looks at radii alone has those of the whole run.
    void whereRadiiAloneAreKeptTheyAndTheTimeAreThoseOfTheWholeRun() {
        for (const Project& p : {fixtures::traverse(), fixtures::plunge()}) {
            const std::unique_ptr<CycleSteps> whole = p.operation == Operation::traverse
                                                          ? traverseSteps(p, Zone::nz, nullptr, {})
                                                          : plungeSteps(p, nullptr, {});
            const std::unique_ptr<CycleSteps> alone = whole->copy();
            alone->run().keepRadiiAlone();
            for (int i = 0; i < 12; ++i) {
                const StepFeed feed{.infeed_mm = 0.004, .axialFeed_mm_min = 900.0 + 100 * (i / 4)};
                QVERIFY(whole->step(feed) && alone->step(feed));
                const auto lanes = static_cast<std::size_t>(p.part->radii_per_section);
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    QCOMPARE(alone->run().depth_mm(lane), whole->run().depth_mm(lane));
                }
                QCOMPARE(alone->remaining(), whole->remaining());
                QCOMPARE(alone->run().time_s(), whole->run().time_s());
                QCOMPARE(alone->run().fed_mm, whole->run().fed_mm);
            }
            QVERIFY(whole->run().sumsOf(0).depth_mm.value > 0);
            QCOMPARE(alone->run().sumsOf(0).depth_mm.value, 0.0);
        }
    }

    // a + γ·P_y(a) + δ_c(P_y(a)) = t_П − depth at every visit that cuts, and no cut without a lag.
    void contactYieldsInEveryPass_data() {
        QTest::addColumn<bool>("traverse");
        QTest::newRow("traverse") << true;
        QTest::newRow("plunge") << false;
    }
    void contactYieldsInEveryPass() {
        QFETCH(bool, traverse);
        const Project p = contacting(traverse ? fixtures::traverse() : fixtures::plunge());
        const Traced run(p);
        QCOMPARE(run.result.status, RunStatus::completed);
        const ContactCompliance contact(rising);
        const fixtures::Law law(p);
        int cutting = 0;
        for (const Pass& pass : run.trajectory.passes) {
            const double gamma = run.result.sections[static_cast<std::size_t>(pass.place.section)]
                                     .compliance_mm_per_n;
            for (int k = 0; k < run.trajectory.radii; ++k) {
                const Visit& visit = run.visit(pass, k);
                const double h = visit.programmed_mm - depthBefore(p, visit, k);
                const double P = law.force(pass.effectiveWidth_mm, visit.actual_mm);
                if (visit.actual_mm > 0) {
                    ++cutting;
                    const double left = visit.actual_mm + gamma * P + contact.deflection(P);
                    QVERIFY(within(left, h, 1e-12));
                } else {
                    QVERIFY(h <= 1e-13);
                }
            }
        }
        QVERIFY(cutting > 100);
    }

    void stiffContactIsNone_data() {
        QTest::addColumn<bool>("coupled");
        QTest::newRow("independent") << false;
        QTest::newRow("coupled") << true;
    }
    void stiffContactIsNone() {
        QFETCH(bool, coupled);
        Project p = slender(4);
        p.sections_coupled = coupled;
        const SimulationResult rigid = simulateUnchecked(p);
        const SimulationResult stiff = simulateUnchecked(contacting(p, {{0, 1e7}})); // 1e-10 mm/N
        QCOMPARE(stiff.countsByStage, rigid.countsByStage);
        for (std::size_t j = 0; j < rigid.sections.size(); ++j) {
            for (std::size_t k = 0; k < 12; ++k) {
                QVERIFY(within(stiff.sections[j].radii_mm[k], rigid.sections[j].radii_mm[k], 2e-7));
            }
        }
    }

    // A constant contact stiffness in series is a softer system: γ + 1/k.
    void constantContactIsComplianceInSeries() {
        const Project p = fixtures::plunge();
        Project softer = p;
        softer.machine->compliance_mm_per_n = std::vector<double>{2e-5 + 1e-5};
        const SimulationResult contact = simulateUnchecked(contacting(p, {{0, 100}}));
        const SimulationResult system = simulateUnchecked(softer);
        QCOMPARE(contact.countsByStage, system.countsByStage);
        for (std::size_t k = 0; k < 4; ++k) {
            QVERIFY(within(contact.sections[0].radii_mm[k], system.sections[0].radii_mm[k], 1e-12));
        }
        QVERIFY(close(contact.peakNormalForce_n, system.peakNormalForce_n, 1e-10));
    }

    // J = 1: the coupled balance with contact is the independent one on G(x,x).
    void oneCoupledSectionWithContactIsTheIndependentOne() {
        const Project coupled = contacting(slender(1));
        Project independent = coupled;
        independent.sections_coupled = false;
        independent.machine->compliance_mm_per_n =
            influenceRows(coupled, {coupled.part->length_mm / 2}, {coupled.part->length_mm / 2});
        const SimulationResult one = simulateUnchecked(coupled),
                               two = simulateUnchecked(independent);
        QCOMPARE(one.status, RunStatus::completed);
        QCOMPARE(one.countsByStage, two.countsByStage);
        for (std::size_t k = 0; k < 12; ++k) {
            QVERIFY(within(one.sections[0].radii_mm[k], two.sections[0].radii_mm[k], 1e-11));
        }
    }

    // a_j + δ_c(L_p·p(a_j)) + Σ_l G_jl·p(a_l)·Δx = t_П − depth_j where it cuts, ≥ where it does
    // not.
    void coupledSectionsYieldAtTheContactToo() {
        constexpr std::size_t J = 5;
        const Project p = contacting(slender(J));
        const Traced run(p);
        QCOMPARE(run.result.status, RunStatus::completed);
        std::vector<double> middles;
        for (std::size_t j = 0; j < J; ++j) {
            middles.push_back(p.part->length_mm * (static_cast<double>(j) + 0.5) / J);
        }
        const std::vector<double> G = influenceRows(p, middles, middles);
        const ContactCompliance contact(rising);
        const fixtures::Law law(p);
        int cutting = 0;
        for (std::size_t first = 0; first < run.trajectory.passes.size(); first += J) {
            for (int k = 0; k < run.trajectory.radii; ++k) {
                for (std::size_t j = 0; j < J; ++j) {
                    const Visit& visit = run.visit(run.trajectory.passes[first + j], k);
                    double left =
                        visit.actual_mm
                        + contact.deflection(law.force(p.part->length_mm, visit.actual_mm));
                    for (std::size_t l = 0; l < J; ++l) {
                        const Visit& other = run.visit(run.trajectory.passes[first + l], k);
                        left += G[j * J + l] * law.force(p.part->length_mm / J, other.actual_mm);
                    }
                    const double h = visit.programmed_mm - depthBefore(p, visit, k);
                    cutting += visit.actual_mm > 0;
                    QVERIFY(visit.actual_mm > 0 ? within(left, h, 1e-12) : left >= h - 1e-12);
                }
            }
        }
        QVERIFY(cutting > 1000);
    }

    // The free gauge stands on a section: it reads that section, contact and all.
    void freeGaugeOnACoupledSectionReadsThatSection() {
        Project free = contacting(slender(5));
        free.gauge->position_mm = free.part->length_mm * 2.5 / 5;
        Project fixed = free;
        fixed.gauge->position_mm.reset();
        fixed.gauge->section = 2;
        const SimulationResult one = simulateUnchecked(free), two = simulateUnchecked(fixed);
        QCOMPARE(one.countsByStage, two.countsByStage);
        QVERIFY(within(one.gaugeReading_mm, two.gaugeReading_mm, 1e-9));
    }

    // η = 0, every radius in contact: all that is left of a blank's form shrinks by
    // r = γ·b·k_s/(1 + γ·b·k_s) in a revolution, lobe number by lobe number.
    void lobesOfTheBlankDecayByTheLinearLaw_data() {
        addColumns<ProfileForm, int>("form", "lobes");
        QTest::newRow("ellipse") << ProfileForm::ellipse << 2;
        QTest::newRow("eccentric") << ProfileForm::eccentric << 1;
        QTest::newRow("5 lobes") << ProfileForm::lobes << 5;
    }
    void lobesOfTheBlankDecayByTheLinearLaw() {
        QFETCH(ProfileForm, form);
        QFETCH(int, lobes);
        Project p = fixtures::plunge();
        p.wheel->dullness = 0;
        p.part->radii_per_section = 36;
        p.part->profile = form;
        p.part->lobes = lobes;
        p.part->initial_runout_mm = 0.02;
        p.machine->compliance_mm_per_n = std::vector<double>{2e-3}; // soft: the form lives long
        p.gauge->control = Control::position;
        const double c = 2e-3 * 40 * fixtures::Law(p).ks;
        const double r = c / (1 + c);
        // The feed's spiral alone: a round blank with the same R_max0, fed as far.
        const auto spiral = [&](int revolutions) {
            Project q = p;
            q.part->stock_mm += q.part->initial_runout_mm;
            q.part->initial_runout_mm = 0;
            q.cycle->stages = {plungeStage(3.6, 0.2), sparkStage(fixtures::count(revolutions))};
            return simulateUnchecked(q).sections[0].radii_mm;
        };
        const auto formLeft = [&](int revolutions) {
            Project q = p;
            q.cycle->stages = {plungeStage(3.6, 0.2), sparkStage(fixtures::count(revolutions))};
            std::vector<double> radii = simulateUnchecked(q).sections[0].radii_mm;
            const std::vector<double> round = spiral(revolutions);
            for (std::size_t k = 0; k < radii.size(); ++k) {
                radii[k] -= round[k];
            }
            return amplitude(radii, lobes);
        };
        const double first = formLeft(2);
        QVERIFY(first > 1e-5);
        for (const int later : {3, 5, 10}) {
            QVERIFY(close(formLeft(later), first * std::pow(r, later - 2), 1e-8));
        }
    }

    // With a dull wheel too: each revolution leaves less of the lobes.
    void lobesOfTheBlankDecayWithADullWheel() {
        Project p = fixtures::plunge();
        p.part->radii_per_section = 36;
        p.part->initial_runout_mm = 0.03;
        p.gauge->control = Control::position;
        p.machine->compliance_mm_per_n = std::vector<double>{2e-4};
        double before = 1;
        for (int revolutions = 1; revolutions <= 20; ++revolutions) {
            p.cycle->stages = {plungeStage(1.8, 0.2), sparkStage(fixtures::count(revolutions))};
            const double now = amplitude(simulateUnchecked(p).sections[0].radii_mm, 2);
            QVERIFY(now < before);
            before = now;
        }
        QVERIFY(before < 1e-3);
    }
};

} // namespace sparkout::test_run_options

SPARKOUT_TEST(test_run_options, TestRunOptions)
#include "test_run_options.moc"
