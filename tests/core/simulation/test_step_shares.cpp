// SPDX-License-Identifier: GPL-3.0-or-later
// What stages and steps take and take off: both add up, and a double stroke takes what the model
// says [MODEL-5].
#include "core/process/system_compliance.h"
#include "core/project/validate.h"
#include "core/simulation/step_shares.h"
#include "core/simulation/traverse.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <numeric>

namespace sparkout::test_step_shares {

using fixtures::within;

struct Shared {
    explicit Shared(const Project& project)
        : result(simulateUnchecked(project, &trajectory)), shares(stepShares(result, trajectory)) {}
    Trajectory trajectory;
    SimulationResult result;
    StepShares shares;
};

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Times and depths are sums of so many terms, each rounded.
double rounding(const Shared& of, double scale) {
    return 4 * fixtures::epsilon * scale * static_cast<double>(of.trajectory.passes.size() + 4);
}

std::vector<Project> samplesOfAll() {
    std::vector<Project> all;
    for (const std::string& name : samples::names()) {
        Project project = samples::project(name);
        if (!hasErrors(validate(project))) {
            all.push_back(std::move(project));
        }
    }
    Project bore = fixtures::plunge();
    bore.part->surface = Surface::internal;
    bore.wheel->diameter_mm = 20;
    bore.part->initial_runout_mm = 0.02;
    all.push_back(bore);
    Project tailstock = fixtures::traverse();
    tailstock.machine->entry_side = EntrySide::tailstock;
    all.push_back(tailstock);
    tailstock.machine->reversal_infeed = ReversalInfeed::both;
    all.push_back(tailstock);
    return all;
}

class TestStepShares : public QObject {
    Q_OBJECT

private slots:
    void timesAddUpToTheStagesAndTheCycle() {
        int stages = 0;
        for (const Project& project : samplesOfAll()) {
            const Shared of(project);
            QCOMPARE(of.shares.time_s.size(), of.result.timeByStage_s.size());
            double all = 0;
            for (std::size_t i = 0; i < of.shares.time_s.size(); ++i) {
                const double total = of.shares.time_s[i].total();
                QVERIFY(within(total, of.result.timeByStage_s[i], rounding(of, of.result.time_s)));
                all += total;
                ++stages;
            }
            QVERIFY(within(all, of.result.time_s, rounding(of, of.result.time_s)));
        }
        QVERIFY(stages >= 12);
    }

    void depthsAddUpToBlankLessPart() {
        int sections = 0;
        for (const Project& project : samplesOfAll()) {
            const Shared of(project);
            const Blank blank = makeBlank(*project.part);
            const double sign = project.part->surface == Surface::external ? 1 : -1;
            for (std::size_t i = 0; i < of.result.sections.size(); ++i) {
                const double before = blank.firstTouchRadius_mm - sign * meanOf(blank.depthAt(i));
                double removed = 0;
                for (const StepSums& stage : of.shares.removed_mm[i]) {
                    removed += stage.total();
                }
                const double after = meanOf(of.result.sections[i].radii_mm);
                QVERIFY2(within(sign * (before - after), removed, rounding(of, before)),
                         project.title.c_str());
                ++sections;
            }
        }
        QVERIFY(sections >= 20);
    }

    void aDoubleStrokeTakesWhatTheModelSays() {
        Project project = fixtures::traverse();
        project.machine->dwell_entry_s = 0.4;
        project.machine->dwell_exit_s = 0.9;
        const Shared of(project);
        const Machine& machine = *project.machine;
        const double turn_s = 60 / machine.work_speed_rpm;
        const double travel_mm = project.part->length_mm - project.wheel->width_mm
                                 + machine.overrun_entry_mm + machine.overrun_exit_mm;
        const int n1 = dwellRevolutions(machine.dwell_entry_s, machine.work_speed_rpm);
        const int n2 = dwellRevolutions(machine.dwell_exit_s, machine.work_speed_rpm);
        QVERIFY(n1 > 0 && n2 > n1);
        for (std::size_t i = 0; i < of.shares.time_s.size(); ++i) {
            const StepSums& time = of.shares.time_s[i];
            const double strokes = of.result.countsByStage[i];
            const double stroke_s = travel_mm / *project.cycle->stages[i].axial_feed_mm_min * 60;
            const double near = rounding(of, of.result.time_s);
            using enum StrokeStep;
            QVERIFY(within(time[entryDwell], strokes * n1 * turn_s, near));
            QVERIFY(within(time[dwellAfterReturn], strokes * n1 * turn_s, near));
            QVERIFY(within(time[exitDwell], strokes * n2 * turn_s, near));
            QVERIFY(within(time[workingStroke], strokes * stroke_s, near));
            QVERIFY(within(time[returnStroke], strokes * stroke_s, near));
            QCOMPARE(time[none], 0.0);
        }
    }

    void aZoneIsGroundInItsOwnStepsAlone() {
        const Shared of(fixtures::traverse());
        for (std::size_t zone = 0; zone < 3; ++zone) {
            for (const StepSums& stage : of.shares.removed_mm[zone]) {
                for (std::size_t step = 0; step < strokeSteps; ++step) {
                    const bool isOwn =
                        stepOf(of.result.sections[zone].zone, static_cast<StrokeStep>(step))
                        != Step::none;
                    QVERIFY(isOwn || stage.of[step] == 0);
                }
            }
        }
        const StepSums& first = of.shares.removed_mm[0].front();
        QVERIFY(first[StrokeStep::plungeIn] > 0 && first[StrokeStep::workingStroke] > 0);
    }

    void stepsOfAZoneAndOfTheStrokeNameEachOther() {
        for (const Zone zone : {Zone::rz1, Zone::nz, Zone::rz2}) {
            int ground = 0;
            for (const Step step : {Step::e1, Step::e2, Step::e3, Step::e4, Step::e5}) {
                const StrokeStep of = strokeStep(zone, step);
                if (of != StrokeStep::none) {
                    QCOMPARE(stepOf(zone, of), step);
                    ++ground;
                }
            }
            QCOMPARE(ground, zone == Zone::rz1 ? 5 : zone == Zone::nz ? 2 : 4);
        }
        QCOMPARE(stepOf(Zone::section, StrokeStep::workingStroke), Step::none);
        QCOMPARE(stepOf(Zone::rz1, StrokeStep::none), Step::none);
    }

    void aRunThatWasNotRecordedHasNone() {
        const SimulationResult result = simulateUnchecked(fixtures::traverse());
        QVERIFY(stepShares(result, {}).empty());
    }
};

} // namespace sparkout::test_step_shares

SPARKOUT_TEST(test_step_shares, TestStepShares)
#include "test_step_shares.moc"
