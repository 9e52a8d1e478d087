// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// A sweep: every point is the run of the project with its values, whatever the threads; what cannot
// be run is told and has no numbers; paths and ranges that are refused are named.
#include "core/batch/sweep_run.h"

#include "core/project/number_input.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "tests/check_line.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <QElapsedTimer>

#include <bit>
#include <set>
#include <thread>

namespace sparkout::test_sweep {

SweepAxis axis(std::string input, double from, double to, int points = 9,
               SweepSpacing spacing = SweepSpacing::linear) {
    return {std::move(input), from, to, points, spacing};
}

Project swept(Project project, std::vector<SweepAxis> axes) {
    project.sweep = Sweep{std::move(axes)};
    return project;
}

Project shaft() {
    Project project = fixtures::traverse();
    project.part->tolerance.radial_runout_um = 6;
    project.part->tolerance.roundness_um = 4;
    project.machine->wheel_drive_kw = 7.5;
    return project;
}

/// The quantity of a name (and section) at a point.
SweepValue valueOf(const SweepResult& result, std::size_t point, const std::string& name,
                   int section = -1) {
    for (std::size_t q = 0; q < result.quantities.size(); ++q) {
        if (result.quantities[q].name == name && result.quantities[q].section == section) {
            return result.points[point].values[q];
        }
    }
    return {};
}

bool sameBits(const SweepResult& a, const SweepResult& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return a.quantities == b.quantities
           && std::ranges::equal(a.points, b.points, [&](const auto& p, const auto& q) {
                  return p.status == q.status && p.run == q.run && p.good == q.good
                         && p.issues == q.issues
                         && std::ranges::equal(p.values, q.values, [&](auto& v, auto& w) {
                                return bits(v.value) == bits(w.value) && bits(v.low) == bits(w.low)
                                       && bits(v.high) == bits(w.high)
                                       && bits(v.margin) == bits(w.margin);
                            });
              });
}

class TestSweep : public QObject {
    Q_OBJECT

private slots:
    void everyPointIsTheRunOfTheProjectWithItsValues_data() {
        QTest::addColumn<Project>("project");
        addRow("traverse, dullness", swept(shaft(), {axis("/wheel/dullness", 0.01, 0.05)}));
        addRow("traverse, compliance over ratios",
               swept(shaft(), {axis("/machine/compliance_mm_per_n/nz", 2e-5, 4e-4, 7,
                                    SweepSpacing::logarithmic)}));
        addRow("traverse, a map",
               swept(shaft(), {axis("/cycle/stages/0/radial_feed_mm", 0.002, 0.01, 4),
                               axis("/machine/dwell_entry_s", 0, 1, 3)}));
        addRow("plunge, feed",
               swept(fixtures::plunge(), {axis("/cycle/stages/0/radial_feed_mm_min", 0.2, 1)}));
    }
    void everyPointIsTheRunOfTheProjectWithItsValues() {
        QFETCH(Project, project);
        QVERIFY(checkSweep(project).empty());
        const SweepResult result = runSweep(project);
        QCOMPARE(static_cast<std::int64_t>(result.points.size()), pointsOf(project));
        QVERIFY(!result.stopped);
        for (std::size_t i = 0; i < result.points.size(); ++i) {
            Project single = project;
            const std::vector<double> values = result.valuesAt(i);
            for (std::size_t a = 0; a < values.size(); ++a) {
                QVERIFY(setNumberInput(single, project.sweep->inputs[a].input, values[a]));
                QVERIFY(*numberInput(single, project.sweep->inputs[a].input)->value == values[a]);
            }
            const SimulationResult run = simulateUnchecked(single);
            QCOMPARE(result.points[i].status, SweepStatus::done);
            QVERIFY(valueOf(result, i, "time").value == run.time_s); // QCOMPARE would round
            QVERIFY(valueOf(result, i, "peak_normal_force").value == run.peakNormalForce_n);
            bool good = true;
            for (const ConstraintResult& constraint : evaluateConstraints(run)) {
                good = good && constraint.holds;
                if (requirementOf(constraint.kind).scope != ConstraintScope::section) {
                    continue;
                }
                const SweepValue at =
                    valueOf(result, i, requirementOf(constraint.kind).key, constraint.section);
                QVERIFY(at.value == constraint.value);
                QVERIFY(at.margin == constraint.margin);
                QVERIFY((std::isnan(at.low) ? at.high : at.low) == constraint.limit);
            }
            QCOMPARE(result.points[i].good, good);
        }
    }

    void anyNumberOfThreadsGivesTheSameBits() {
        const Project project = swept(shaft(), {axis("/wheel/dullness", 0.005, 0.06, 11),
                                                axis("/part/stock_mm", 0.05, 0.3, 5)});
        SweepOptions one, four;
        one.threads = 1;
        four.threads = 4;
        QVERIFY(sameBits(runSweep(project, one), runSweep(project, four)));
    }

    /// Also where the setting is at the very end.
    void theEndOfAMachinesRangeStandsOnItsSide() {
        Project project = shaft();
        project.machine->limits.work_speed_rpm = {50, 500, 5};
        const SweepResult result =
            runSweep(swept(project, {axis("/machine/work_speed_rpm", 50, 500, 2)}), {});
        const SweepValue lowest = valueOf(result, 0, "range_work_speed");
        QVERIFY(lowest.low == 50 && std::isnan(lowest.high) && lowest.margin == 0);
        const SweepValue highest = valueOf(result, 1, "range_work_speed");
        QVERIFY(highest.high == 500 && std::isnan(highest.low) && highest.margin == 0);
        // What is set has no margin of the kind that is told of the part.
        project.machine->work_speed_rpm = 50;
        const SimulationResult alone = simulateUnchecked(project);
        double least = HUGE_VAL;
        for (const ConstraintResult& constraint : evaluateConstraints(alone)) {
            if (requirementOf(constraint.kind).scope != ConstraintScope::setting) {
                least = std::min(least, constraint.relativeMargin);
            }
        }
        QVERIFY(least != 0);
        QCOMPARE(valueOf(result, 0, "least_margin").value, least * 100);
        QCOMPARE(valueOf(result, 0, "peak_power").value, alone.peakPower_w / 1000);
    }

    void aLongerSparkOutLeavesLessRunout() {
        Project project = fixtures::plunge();
        project.part->initial_runout_mm = 0.02;
        project.part->radii_per_section = 12;
        project.cycle->stages.push_back(fixtures::sparkStage(fixtures::count(1)));
        project.machine->compliance_mm_per_n =
            std::vector<double>(static_cast<std::size_t>(project.sections), 2e-4);
        project =
            swept(project, {axis("/cycle/stages/" + std::to_string(project.cycle->stages.size() - 1)
                                     + "/spark_out",
                                 1, 30, 10)});
        QCOMPARE(checkSweep(project), Issues());
        const SweepResult result = runSweep(project);
        QVERIFY(result.points.size() >= 8);
        for (std::size_t i = 1; i < result.points.size(); ++i) {
            QVERIFY(valueOf(result, i, "radial_runout", 0).value
                    < valueOf(result, i - 1, "radial_runout", 0).value);
            QVERIFY(valueOf(result, i, "time").value > valueOf(result, i - 1, "time").value);
        }
    }

    void whatCannotBeRunIsToldAndHasNoNumbers() {
        // A wheel narrower than the overrun leaves no reversal zone: refused by a rule.
        const Project whole = shaft();
        const Project narrow =
            swept(whole, {axis("/machine/overrun_entry_mm", 5, whole.wheel->width_mm + 20, 8)});
        const SweepResult result = runSweep(narrow);
        int refused = 0;
        for (const SweepPoint& point : result.points) {
            QVERIFY(point.status == SweepStatus::done || point.status == SweepStatus::refused);
            QCOMPARE(point.values.empty(), point.status == SweepStatus::refused);
            QCOMPARE(point.issues.empty(), point.status == SweepStatus::done);
            QVERIFY(point.status == SweepStatus::done || !point.good);
            refused += point.status == SweepStatus::refused ? 1 : 0;
        }
        QVERIFY(refused > 0 && refused < static_cast<int>(result.points.size()));
        // A spark-out of a few revolutions gives back less than its stock: size is not reached.
        Project plunge = fixtures::plunge();
        plunge.cycle->stages.push_back(fixtures::sparkStage(fixtures::untilSize(), 0.01));
        plunge.machine->compliance_mm_per_n =
            std::vector<double>(static_cast<std::size_t>(plunge.sections), 1e-6);
        const std::string last =
            "/cycle/stages/" + std::to_string(plunge.cycle->stages.size() - 1) + "/stock_mm";
        const SweepResult stuck = runSweep(swept(plunge, {axis(last, 0, 0.05, 6)}));
        QVERIFY(std::ranges::any_of(stuck.points, [](const SweepPoint& point) {
            return point.status == SweepStatus::notReached && point.values.empty()
                   && point.run != RunStatus::completed;
        }));
    }

    void aStopEndsItAtOnceAndKeepsWhatWasDone() {
        const Project project = swept(shaft(), {axis("/wheel/dullness", 0.005, 0.06, 101),
                                                axis("/part/stock_mm", 0.05, 0.3, 101)});
        std::stop_source source;
        std::atomic<std::int64_t> done = 0;
        SweepOptions options;
        options.threads = 2;
        options.stop = source.get_token();
        options.done = &done;
        QElapsedTimer stopped;
        std::jthread stopper([&] {
            while (done < 20) {
                std::this_thread::yield();
            }
            stopped.start();
            source.request_stop();
        });
        const SweepResult result = runSweep(project, options);
        const qint64 took_ms = stopped.elapsed();
        stopper.join();
        qInfo("SWEEP stopped after %lld ms, target 100 ms: %s", took_ms,
              beside(double(took_ms), 100));
        QVERIFY(took_ms < 400); // a busy machine
        QVERIFY(result.stopped);
        const auto kept = std::ranges::count_if(result.points, [](const SweepPoint& point) {
            return point.status != SweepStatus::pending;
        });
        QVERIFY(kept >= 20 && kept < 101 * 101);
        QCOMPARE(kept, static_cast<std::ptrdiff_t>(done.load()));
    }

    void valuesHaveBothEndsAndWholeNumbersOnce() {
        const std::vector<double> linear = sweepValues(axis("", 0.01, 0.04, 7), false);
        QCOMPARE(linear, (std::vector<double>{0.01, 0.015, 0.02, 0.025, 0.03, 0.035, 0.04}));
        const auto ratios = sweepValues(axis("", 1, 1000, 4, SweepSpacing::logarithmic), false);
        QCOMPARE(ratios, (std::vector<double>{1, 10, 100, 1000}));
        QCOMPARE(sweepValues(axis("", 1, 4, 21), true), (std::vector<double>{1, 2, 3, 4}));
        QCOMPARE(sweepValues(axis("", 1.0 / 3, 2.0 / 3, 2), false),
                 (std::vector<double>{1.0 / 3, 2.0 / 3}));
    }

    void everyNumberOfAProjectCanBeSetByItsPath() {
        for (const Project& project : {shaft(), fixtures::plunge()}) {
            std::set<std::string> paths;
            for (const NumberInput& input : numberInputs(project)) {
                QVERIFY2(paths.insert(input.path).second, input.path.c_str());
                Project changed = project;
                const double value = input.value.value_or(1) + 1;
                QVERIFY(setNumberInput(changed, input.path, value));
                QVERIFY2(*numberInput(changed, input.path)->value == value, input.path.c_str());
                QVERIFY(!sameProject(changed, project));
                if (input.value) { // nothing else has changed
                    QVERIFY(setNumberInput(changed, input.path, *input.value));
                    QVERIFY(sameProject(changed, project));
                }
            }
            for (const char* path : {"/wheel/dullness", "/machine/compliance_mm_per_n/0",
                                     "/machine/compliance_mm_per_n/rz1", "/part/stock_mm",
                                     "/cycle/stages/0/stock_mm"}) {
                const bool zones = project.operation == Operation::traverse;
                const bool other = std::string_view(path).ends_with(zones ? "/0" : "/rz1");
                QCOMPARE(paths.contains(path), !other);
            }
        }
    }

    void refusedPathsAndRangesAreNamed_data() {
        addColumns<SweepAxis, QString, QString, QString>("axis", "path", "value", "limit");
        const auto row = [](const char* name, const SweepAxis& axis, const char* path,
                            const char* value,
                            const char* limit) { addRow(name, axis, path, value, limit); };
        row("no such input", axis("/wheel/sharpness", 0, 1), "/sweep/inputs/0/input",
            "\"/wheel/sharpness\"", "the path of an input, as /wheel/dullness");
        row("no number", axis("/wheel/marking", 0, 1), "/sweep/inputs/0/input",
            "\"/wheel/marking\"", "the path of an input, as /wheel/dullness");
        row("a stage that is not there", axis("/cycle/stages/9/stock_mm", 0, 1),
            "/sweep/inputs/0/input", "\"/cycle/stages/9/stock_mm\"",
            "the path of an input, as /wheel/dullness");
        row("of the other operation", axis("/cycle/stages/0/radial_feed_mm_min", 0.1, 1),
            "/sweep/inputs/0/input", "\"/cycle/stages/0/radial_feed_mm_min\"",
            "the path of an input, as /wheel/dullness");
        row("below the limits", axis("/part/stock_mm", -1, 1), "/sweep/inputs/0/from", "-1 mm",
            "> 0…5 mm");
        row("beyond the limits", axis("/part/stock_mm", 0.1, 7), "/sweep/inputs/0/to", "7 mm",
            "> 0…5 mm");
        row("backwards", axis("/part/stock_mm", 0.2, 0.1), "/sweep/inputs/0/to", "0.1 mm",
            "> 0.2 mm");
        row("ratios from zero", axis("/machine/dwell_entry_s", 0, 1, 5, SweepSpacing::logarithmic),
            "/sweep/inputs/0/from", "0 s", "> 0 s");
        row("half a command", axis("/gauge/commands", 1.5, 3), "/sweep/inputs/0/from", "1.5",
            "whole number");
    }
    void refusedPathsAndRangesAreNamed() {
        QFETCH(SweepAxis, axis);
        QFETCH(QString, path);
        QFETCH(QString, value);
        QFETCH(QString, limit);
        const Project project = swept(shaft(), {axis});
        const Issues issues = checkSweep(project);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(issues[0].path), path);
        QCOMPARE(QString::fromStdString(Wording().detail(issues[0].value)), value);
        QCOMPARE(QString::fromStdString(Wording().detail(issues[0].limit)), limit);
        QCOMPARE(pointsOf(project), std::int64_t{0});
        // A single cycle does not read them: it is only warned.
        const Issues warned = validate(project);
        QVERIFY(!hasErrors(warned));
        QVERIFY(std::ranges::any_of(
            warned, [&](const Issue& issue) { return issue.path == issues[0].path; }));
    }

    void whatCannotBeRunHasNoPointAndSaysWhy() {
        Project noSweep = shaft();
        const Project onePoint = swept(shaft(), {axis("/wheel/dullness", 0.01, 0.02, 1)}),
                      noPoint = swept(shaft(), {axis("/wheel/dullness", 0.01, 0.02, -1)}),
                      noAxis = swept(shaft(), {}),
                      threeAxes = swept(shaft(), {axis("/wheel/dullness", 0.01, 0.02),
                                                  axis("/part/stock_mm", 0.1, 0.2),
                                                  axis("/part/length_mm", 90, 95)}),
                      noPath = swept(shaft(), {axis("/wheel", 0.01, 0.02)});
        for (const Project& project :
             {noSweep, onePoint, noPoint, noAxis, threeAxes, noPath, Project{}}) {
            const SweepResult result = runSweep(project);
            QVERIFY(!result.ran() && result.issues == checkSweep(project));
            QVERIFY(result.points.empty() && result.inputs.empty() && !result.stopped);
            QCOMPARE(pointsOf(project), std::int64_t{0});
        }
        // Of a project that is none every point is refused.
        Project noProject = swept(shaft(), {axis("/wheel/dullness", 0.01, 0.02, 2)});
        noProject.cycle->stages.clear();
        const SweepResult result = runSweep(noProject);
        QVERIFY(result.ran() && result.points.size() == 2);
        for (const SweepPoint& point : result.points) {
            QCOMPARE(point.status, SweepStatus::refused);
            QVERIFY(!point.issues.empty());
        }
    }

    void oneInputIsNotVariedTwice() {
        const Project project = swept(
            shaft(), {axis("/wheel/dullness", 0.01, 0.02), axis("/wheel/dullness", 0.01, 0.03)});
        const Issues issues = checkSweep(project);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].code, IssueCode::variedTwice);
        QCOMPARE(issues[0].path, std::string("/sweep/inputs/1/input"));
    }

    void aSweepComesBackFromItsFile() {
        const Project project =
            swept(shaft(), {axis("/wheel/dullness", 0.01, 0.04, 11),
                            axis("/part/stock_mm", 0.1, 0.3, 5, SweepSpacing::logarithmic)});
        const ReadResult read = readProject(writeProject(project));
        QVERIFY(read.project && read.project->sweep);
        QVERIFY(sameProject(*read.project, project));
        const SweepAxis& second = read.project->sweep->inputs[1];
        QCOMPARE(second.input, std::string("/part/stock_mm"));
        QCOMPARE(second.points, 5);
        QCOMPARE(second.spacing, SweepSpacing::logarithmic);
        // Without one the file has no such key, and reads as before.
        QVERIFY(writeProject(shaft()).find("sweep") == std::string::npos);
        QVERIFY(!readProject(writeProject(shaft())).project->sweep);
    }
};

} // namespace sparkout::test_sweep

SPARKOUT_TEST(test_sweep, TestSweep)
#include "test_sweep.moc"
