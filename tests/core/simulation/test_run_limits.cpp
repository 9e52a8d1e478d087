// SPDX-License-Identifier: GPL-3.0-or-later
// What a run keeps of its passes for the requirements: held against a search through everything
// that was recorded, with the formulas written a second time.
#include "core/quality/constraints.h"
#include "core/quality/cycle_constraints.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/simulation/stage_control.h"
#include "core/surface/burn.h"

#include "tests/core/support/allocation_counter.h"
#include "tests/core/support/demanding_project.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <iterator>

namespace sparkout::test_run_limits {

using fixtures::close;
using fixtures::plungeOfThree;
using fixtures::plungeStage;
using fixtures::sparkStage;
using fixtures::strokeStage;
using fixtures::Traced;
using fixtures::within;

/// The table of limiting depths is true to a millionth of √a; two of them meet in a comparison.
constexpr double tableError = 4e-6;

/// Asks for everything there is to ask.
Project asking(const Project& of) {
    Project p = fixtures::demanding(of);
    p.machine->limits.radial_feed_mm = std::vector<double>{0.0005, 0.02, 0.0005};
    p.machine->limits.axial_feed_mm_min = std::vector<double>{50, 5000, 50};
    p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.02, 5, 0.01};
    p.machine->limits.work_speed_rpm = std::vector<double>{50, 500, 5};
    p.part->tolerance.waviness_um = 50;
    return p;
}

/// The same without anything asked.
Project silent(Project p) {
    p.material->burn_rise_k.reset();
    p.part->tolerance = {};
    p.machine->wheel_drive_kw.reset();
    p.machine->work_drive_kw.reset();
    p.wheel->grain_surface_energy_j_m2.reset();
    p.machine->limits = {};
    p.gauge->control = Control::gauge;
    return p;
}

Project coupled(Project p) {
    fixtures::putOnSlenderShaft(p);
    p.sections_coupled = true;
    return p;
}

Project bore() {
    Project p = plungeOfThree();
    p.part->surface = Surface::internal;
    p.part->diameter_mm = 60;
    p.part->lower_deviation_um = 0;
    p.part->upper_deviation_um = 30;
    p.wheel->diameter_mm = 45;
    return p;
}

Project withContact(Project p) {
    p.machine->wheel_contact = WheelContact{NumberRows{{{10, 5}, {100, 20}, {400, 60}}}};
    return p;
}

void everyProject() {
    QTest::addColumn<Project>("project");
    const Project stroke = fixtures::traverse();
    Project threeLobes = stroke;
    threeLobes.part->profile = ProfileForm::lobes;
    threeLobes.part->initial_runout_mm = 0.05;
    threeLobes.cycle->stages.push_back(sparkStage(fixtures::count(3), 0, 600));
    Project retracting = fixtures::plunge();
    retracting.machine->compliance_mm_per_n = std::vector<double>{1e-4};
    retracting.cycle->stages = {plungeStage(1.8, 0.185), plungeStage(-0.6, 0.01),
                                plungeStage(0.05, 0.005)};
    QTest::newRow("traverse") << asking(stroke);
    QTest::newRow("traverse, three lobes, spark-out") << asking(threeLobes);
    QTest::newRow("traverse, contact") << asking(withContact(stroke));
    QTest::newRow("plunge") << asking(plungeOfThree());
    QTest::newRow("plunge, contact") << asking(withContact(plungeOfThree()));
    QTest::newRow("coupled") << asking(coupled(plungeOfThree()));
    QTest::newRow("coupled, contact") << asking(withContact(coupled(plungeOfThree())));
    QTest::newRow("bore") << asking(bore());
    Project slow = plungeOfThree(); // hardly nearer to burning from one revolution to the next
    slow.cycle->stages = {plungeStage(0.05, 0.2)};
    QTest::newRow("slow") << asking(slow);
    QTest::newRow("retraction") << asking(retracting);
}

double target(const Project& p) {
    return makeBlank(*p.part).targetRadius_mm;
}

/// max(0, R_k − R_t), of a bore mirrored.
double stockLeft(const Project& p, const Visit& visit) {
    const double left = visit.radius_mm - target(p);
    return std::max(0.0, p.part->surface == Surface::external ? left : -left);
}

const ConstraintResult* find(const std::vector<ConstraintResult>& all, ConstraintKind kind) {
    const auto found = std::ranges::find(all, kind, &ConstraintResult::kind);
    return found == all.end() ? nullptr : &*found;
}

bool samePlace(const Place& a, const Place& b) {
    return a.zone == b.zone && a.section == b.section && a.step == b.step && a.stage == b.stage
           && a.cycleCount == b.cycleCount && a.revolution == b.revolution;
}

/// The law of LastCut worked out from everything that was recorded of a zone or section.
LastCut lastCutOf(const Traced& run, int section, int ofAlike) {
    const Project& project = run.result.project;
    std::vector<double> begins_s; // of the steps, by all passes
    for (const Pass& pass : run.trajectory.passes) {
        if (begins_s.size() < static_cast<std::size_t>(pass.place.cycleCount)) {
            begins_s.push_back(pass.start_s);
        }
    }
    begins_s.push_back(run.result.time_s);
    const std::vector<double> blank_mm = makeBlank(*project.part).depth_mm;
    const auto K = static_cast<std::size_t>(run.trajectory.radii);
    std::vector<double> depth_mm = blank_mm, taken_mm(K), pressed_mm(K);
    double fed_mm = firstFeed(project, makeBlank(*project.part).totalInfeed_mm), whole_mm = 0;
    int wholeStage = 0;
    LastCut last;
    const std::vector<Pass> passes = run.passesOf(section);
    for (std::size_t i = 0; i < passes.size();) {
        const Pass& first = passes[i];
        const auto step = static_cast<std::size_t>(first.place.cycleCount);
        const bool feeds = first.radialFeed_mm > 0;
        const bool isShort =
            feeds && first.place.stage == wholeStage && first.radialFeed_mm < whole_mm * (1 - 1e-9);
        std::vector<double> now_mm(K);
        for (; i < passes.size() && passes[i].place.cycleCount == first.place.cycleCount; ++i) {
            for (std::size_t k = 0; k < K; ++k) {
                now_mm[k] += run.visit(passes[i], static_cast<int>(k)).actual_mm;
            }
        }
        fed_mm += first.radialFeed_mm;
        for (std::size_t k = 0; k < K; ++k) {
            if (feeds && now_mm[k] > (isShort ? taken_mm[k] : 0)) {
                taken_mm[k] = now_mm[k];
                // in a plunge the infeed grows with the angle
                const double share = project.operation->travels
                                         ? 1
                                         : static_cast<double>(k + 1) / static_cast<double>(K);
                pressed_mm[k] = fed_mm - first.radialFeed_mm * (1 - share) - depth_mm[k];
            }
            depth_mm[k] += now_mm[k];
        }
        if (feeds && !isShort) {
            wholeStage = first.place.stage;
            whole_mm = first.radialFeed_mm;
            last.step_s = begins_s[step] - begins_s[step - 1];
            last.at = first.place;
        }
        last.sparkOut_s = feeds ? 0 : last.sparkOut_s + begins_s[step] - begins_s[step - 1];
    }
    for (std::size_t k = 0; k < K; ++k) {
        if (taken_mm[k] > last.depth_mm) {
            last.depth_mm = taken_mm[k];
            last.pressed_mm = pressed_mm[k];
            last.radius = static_cast<int>(k);
        }
    }
    // Of radii that lost the same but for rounding any may be the one.
    const auto alike = static_cast<std::size_t>(ofAlike);
    if (taken_mm[alike] > last.depth_mm * (1 - 1e-10)) {
        last.pressed_mm = pressed_mm[alike];
    }
    return last;
}

class TestRunLimits : public QObject {
    Q_OBJECT

private slots:
    void burnIsTheVisitNearestToItsLimit_data() { everyProject(); }
    void burnIsTheVisitNearestToItsLimit() {
        QFETCH(Project, project);
        const Traced run(project);
        const BurnModel model(project);
        const double U = *project.material->burn_rise_k;
        double worst = 0;
        bool placed = false;
        const BurnVisit& kept = run.result.burn.value();
        for (const Pass& pass : run.trajectory.passes) {
            for (int k = 0; k < run.trajectory.radii; ++k) {
                const Visit& visit = run.visit(pass, k);
                if (visit.actual_mm > 0) {
                    const double limit = model.limitDepth(U, stockLeft(project, visit));
                    worst = std::max(worst, std::sqrt(visit.actual_mm / limit));
                }
                placed = placed
                         || (samePlace(pass.place, kept.at) && k == kept.radius
                             && visit.actual_mm == kept.depth_mm
                             && within(stockLeft(project, visit), kept.stock_mm, 1e-13));
            }
        }
        QVERIFY2(placed, "the place holds what is kept");
        const auto all = evaluateConstraints(run.result);
        const ConstraintResult& burn = *find(all, ConstraintKind::burn);
        QVERIFY(close(std::sqrt(burn.value / burn.limit), worst, tableError));
        QVERIFY(within(burn.margin, burn.limit - burn.value, 1e-12));
        QVERIFY(within(burn.relativeMargin, 1 - worst * worst, 2 * tableError * worst * worst));
        // The depth is within its limit exactly where the damaged layer is within the stock.
        const double damaged = model.damagedDepth(burn.value / 1000, U);
        QCOMPARE(burn.holds, damaged <= kept.stock_mm);
        const BurnState state = burnStateOf(run.result).value();
        QCOMPARE(state.damagedDepth_mm, damaged);
        QCOMPARE(burn.holds, state.rise_k <= U);
    }

    // The rise that burns decides: some hold, some do not.
    void burnFailsBelowTheRiseReachedAndHoldsAbove() {
        Project p = asking(plungeOfThree());
        const double reached = burnStateOf(simulateUnchecked(p)).value().rise_k;
        for (const double U : {0.5 * reached, 1.5 * reached}) {
            p.material->burn_rise_k = U;
            const auto all = evaluateConstraints(simulateUnchecked(p));
            QCOMPARE(find(all, ConstraintKind::burn)->holds, U > reached);
        }
    }

    // Of each radius what the last revolution or double stroke with infeed took that cut it, of
    // these the most.
    void roughnessIsOfWhatTheLastStepWithInfeedTook_data() {
        everyProject();
        Project cutShort = plungeOfThree();
        cutShort.gauge->control = Control::position;
        cutShort.cycle->stages = {plungeStage(1.2, 0.15), plungeStage(0.31, 0.0503)};
        QTest::newRow("cut short by position control") << asking(cutShort);
    }
    void roughnessIsOfWhatTheLastStepWithInfeedTook() {
        QFETCH(Project, project);
        const Traced run(project);
        const auto all = evaluateConstraints(run.result);
        for (std::size_t j = 0; j < run.result.sections.size(); ++j) {
            const LastCut& kept = run.result.sections[j].lastCut.value();
            const LastCut wanted = lastCutOf(run, static_cast<int>(j), kept.radius);
            QVERIFY(close(kept.depth_mm, wanted.depth_mm, 1e-10));
            QVERIFY(close(kept.pressed_mm, wanted.pressed_mm, 1e-9));
            QVERIFY(close(kept.step_s, wanted.step_s, 1e-9));
            QVERIFY(within(kept.sparkOut_s, wanted.sparkOut_s, 1e-9 * run.result.time_s));
            QVERIFY(samePlace(kept.at, wanted.at));
            QVERIFY(kept.pressed_mm >= kept.depth_mm);
            const auto found = std::ranges::find_if(all, [&](const ConstraintResult& c) {
                return c.kind == ConstraintKind::roughness && c.section == static_cast<int>(j);
            });
            QVERIFY(found != all.end() && samePlace(found->at.value(), kept.at));
            QCOMPARE(found->value, RoughnessModel(project).roughness(kept) * 1000);
        }
    }

    // Where nothing yields, what is fed is cut at once, in every zone alike.
    void zonesWithTheSameLastInfeedAreEquallyRough() {
        Project project = asking(fixtures::traverse());
        project.machine->compliance_mm_per_n = ZoneCompliance{1e-12, 1e-12, 1e-12};
        project.cycle->stages.push_back(sparkStage(fixtures::count(2), 0, 600));
        const SimulationResult result = simulateUnchecked(project);
        const RoughnessModel model(project);
        const double Ra = model.roughness(*result.sections[1].lastCut);
        QVERIFY(result.sections[1].lastCut->sparkOut_s > 0 && Ra > 0);
        for (const SectionResult& zone : result.sections) {
            QVERIFY(close(zone.lastCut->depth_mm, 0.001, 1e-6));
            QVERIFY(close(model.roughness(*zone.lastCut), Ra, 1e-6));
        }
    }

    // A spark-out of none, one, two … revolutions: from what the infeed left towards half of it.
    void roughnessFallsInTheSparkOutTowardsARest() {
        Project project = asking(plungeOfThree());
        project.gauge->control = Control::position;
        project.cycle->stages = {plungeStage(1.2, 0.15), plungeStage(0.3, 0.05)};
        const RoughnessModel model(project);
        const auto left = [&](const Project& p) {
            return model.roughness(*simulateUnchecked(p).sections[2].lastCut);
        };
        const double straight = left(project);
        double before = straight;
        for (const int revolutions : {1, 2, 5, 20, 100, 400}) {
            Project sparking = project;
            sparking.cycle->stages.push_back(sparkStage(fixtures::count(revolutions)));
            const double Ra = left(sparking);
            QVERIFY(Ra < before && Ra >= straight / 2);
            if (revolutions == 1) {
                QVERIFY(Ra > 0.8 * straight); // τ is two revolutions at least
            }
            before = Ra;
        }
        QVERIFY(close(before, straight / 2, 0.01));
    }

    void powerIsTheLargestOfAllPasses_data() { everyProject(); }
    void powerIsTheLargestOfAllPasses() {
        QFETCH(Project, project);
        if (project.sections_coupled) {
            QSKIP("the force of coupled sections is an integral: test_coupled_plunge");
        }
        const Traced run(project);
        const fixtures::Law law(project);
        const double Vk = project.machine->wheel_speed_m_s * 1000;
        const double Vd =
            std::numbers::pi * project.part->diameter_mm * project.machine->work_speed_rpm / 60;
        const double kt =
            project.material->shear_strain * project.material->flow_stress_mpa * Vd / Vk;
        double wheel = 0, work = 0;
        for (const Pass& pass : run.trajectory.passes) {
            for (int k = 0; k < run.trajectory.radii; ++k) {
                const double a = run.visit(pass, k).actual_mm;
                const double Pz = pass.effectiveWidth_mm
                                  * (kt * a + project.material->friction * law.kr * std::sqrt(a));
                wheel = std::max(wheel, Pz * Vk / 1e6);
                work = std::max(work, Pz * Vd / 1e6);
            }
        }
        const auto all = evaluateConstraints(run.result);
        QVERIFY(close(find(all, ConstraintKind::wheelPower)->value, wheel, 1e-12));
        QVERIFY(close(find(all, ConstraintKind::workPower)->value, work, 1e-12));
        QVERIFY(find(all, ConstraintKind::wheelPower)->at.has_value());
        QCOMPARE(find(all, ConstraintKind::wheelPower)->holds, wheel <= 5);
        QCOMPARE(find(all, ConstraintKind::workPower)->holds, work <= 0.5);
    }

    void pressureOnTheWheelIsTheLargestOfAllPasses_data() { everyProject(); }
    void pressureOnTheWheelIsTheLargestOfAllPasses() {
        QFETCH(Project, project);
        const Traced run(project);
        const fixtures::Law law(project);
        const double d = project.part->diameter_mm, D = project.wheel->diameter_mm;
        const double De =
            project.part->surface == Surface::external ? d * D / (D + d) : d * D / (d - D);
        double largest = 0;
        for (const Pass& pass : run.trajectory.passes) {
            for (int k = 0; k < run.trajectory.radii; ++k) {
                const double a = run.visit(pass, k).actual_mm;
                if (a > 0) {
                    largest = std::max(largest, law.force(1, a) / std::sqrt(a * De));
                }
            }
        }
        const auto all = evaluateConstraints(run.result);
        const ConstraintResult& found = *find(all, ConstraintKind::selfSharpening);
        QVERIFY(close(found.value, largest, 1e-12));
        QCOMPARE(found.limit, selfSharpening(project)->allowedPressure_mpa);
        QCOMPARE(found.holds, largest <= found.limit);
    }

    void whatIsNotAskedIsNotKeptNorListed_data() { everyProject(); }
    void whatIsNotAskedIsNotKeptNorListed() {
        QFETCH(Project, project);
        const SimulationResult plain = simulateUnchecked(silent(project));
        QVERIFY(!plain.burn);
        for (const SectionResult& section : plain.sections) {
            QVERIFY(!section.lastCut);
        }
        for (const ConstraintResult& c : evaluateConstraints(plain)) {
            QVERIFY(c.kind == ConstraintKind::diameterMin || c.kind == ConstraintKind::diameterMax
                    || c.kind == ConstraintKind::gaugeCommands
                    || c.kind == ConstraintKind::overlap);
        }
    }

    void askingChangesNoCycle_data() { everyProject(); }
    void askingChangesNoCycle() {
        QFETCH(Project, project);
        QVERIFY(fixtures::sameBits(simulateUnchecked(project), simulateUnchecked(silent(project))));
        const SimulationResult plain = simulateUnchecked(project);
        const Traced traced(project);
        QVERIFY(fixtures::sameBits(plain, traced.result));
        QCOMPARE(plain.burn->depth_mm, traced.result.burn->depth_mm);
        QCOMPARE(plain.burn->stock_mm, traced.result.burn->stock_mm);
    }

    void passesAllocateNothing_data() {
        addColumns<bool, bool>("contact", "isCoupled");
        QTest::newRow("plain") << false << false;
        QTest::newRow("contact") << true << false;
        QTest::newRow("coupled") << false << true;
        QTest::newRow("coupled, contact") << true << true;
    }
    void passesAllocateNothing() {
        QFETCH(bool, contact);
        QFETCH(bool, isCoupled);
        const auto allocationsOf = [&](int sparking) {
            Project p = asking(plungeOfThree());
            p = contact ? withContact(p) : p;
            p = isCoupled ? coupled(p) : p;
            p.cycle->stages.back() = sparkStage(fixtures::count(sparking));
            const long long before = allocations::count;
            const SimulationResult r = simulateUnchecked(p);
            return r.status != RunStatus::completed ? -1 : allocations::count - before;
        };
        QCOMPARE(allocationsOf(800), allocationsOf(8));
    }

    void everyKindIsListedWhenAskedFor() {
        Project p = asking(fixtures::traverse());
        p.least_overlap_last = 2;
        p.least_steps = 2;
        p.machine->limits.continuous_feed_mm_min = std::vector<double>{0.01, 1, 0.01};
        p.cycle->stages[0].continuous_feed_mm_min = 0.02;
        auto stroke = evaluateConstraints(simulateUnchecked(p));
        p.least_overlap = 1.05; // takes the place of the overlap that leaves no strips
        std::ranges::copy(evaluateConstraints(simulateUnchecked(p)), std::back_inserter(stroke));
        for (int kind = 0; kind < constraintKinds; ++kind) {
            QVERIFY2(find(stroke, static_cast<ConstraintKind>(kind)),
                     requirementOf(static_cast<ConstraintKind>(kind)).key);
        }
        const auto plunge = evaluateConstraints(simulateUnchecked(asking(plungeOfThree())));
        QVERIFY(!find(plunge, ConstraintKind::rangeRadialFeed));
        QVERIFY(!find(plunge, ConstraintKind::rangeAxialFeed));
    }

    void settingsSayTheirStageAndTheNearerEnd() {
        Project p = asking(fixtures::traverse());
        p.cycle->stages = {strokeStage(0.03, 1800, 0.11), strokeStage(0.001, 20, 0.04)};
        p.gauge->commands = 1;
        const auto worst = worstByKind(evaluateConstraints(simulateUnchecked(p)));
        const ConstraintResult& feed = *find(worst, ConstraintKind::rangeRadialFeed);
        QVERIFY(!feed.holds && feed.stage == 1 && feed.limit == 0.02);
        QVERIFY(within(feed.margin, -0.01, 1e-15));
        const ConstraintResult& axial = *find(worst, ConstraintKind::rangeAxialFeed);
        QVERIFY(!axial.holds && axial.stage == 2 && axial.limit == 50 && axial.margin == -30);
        const ConstraintResult& commands = *find(worst, ConstraintKind::gaugeCommands);
        QVERIFY(!commands.holds && commands.value == 2 && commands.limit == 1);
        p.gauge->control = Control::position;
        QVERIFY(!find(evaluateConstraints(simulateUnchecked(p)), ConstraintKind::gaugeCommands));
    }

    void retractionIsAsFastAsAFeed() {
        Project p = asking(fixtures::plunge());
        p.cycle->stages = {plungeStage(1.8, 0.185), plungeStage(-0.6, 0.01),
                           plungeStage(0.05, 0.005)};
        const auto all = evaluateConstraints(simulateUnchecked(p));
        QVERIFY(find(all, ConstraintKind::rangePlungeFeed)->holds);
    }

    // The form of the part, from the result and from the accuracy given, is the same.
    void formIsThatOfTheSections_data() { everyProject(); }
    void formIsThatOfTheSections() {
        QFETCH(Project, project);
        project.machine->geometric_runout_um = 1.5;
        const SimulationResult result = simulateUnchecked(project);
        const PartAccuracy accuracy = accuracyOf(result);
        const auto lean = evaluateConstraints(result);
        const auto full = evaluateConstraints(result, accuracy);
        QCOMPARE(lean.size(), full.size());
        for (std::size_t i = 0; i < lean.size(); ++i) {
            // the cylinder is sought from the same least squares, the circle with or without them
            QVERIFY(within(lean[i].value, full[i].value, 1e-7));
        }
        double low = 1e9, high = 0;
        for (const SectionResult& section : result.sections) {
            const auto [least, most] = std::ranges::minmax(section.radii_mm);
            low = std::min(low, least);
            high = std::max(high, most);
            const double round =
                find(full, ConstraintKind::roundness)->value; // of the first section
            QVERIFY(&section != &result.sections[0] || round <= (most - least) * 1000 + 1e-9);
        }
        QVERIFY(within(find(full, ConstraintKind::totalRunout)->value, (high - low) * 1000 + 1.5,
                       1e-9));
        QVERIFY(find(full, ConstraintKind::cylindricity)->value
                <= (high - low) * 1000 + 1e-6); // the centre axis is one of the axes
    }
};

} // namespace sparkout::test_run_limits

SPARKOUT_TEST(test_run_limits, TestRunLimits)
#include "test_run_limits.moc"
