// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/simulate.h"

#include "tests/core/support/allocation_counter.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <chrono>
#include <stop_token>
#include <thread>

namespace sparkout::test_traverse_cycle {

using fixtures::close;
using fixtures::sparkStage;
using fixtures::strokeStage;
using fixtures::Traced;
using fixtures::within;

/// One line of MODEL-5's table, for one zone.
struct Line {
    Zone zone;
    Step step;
    int passes;   ///< revolutions, or one stroke
    double width; ///< b [mm]
    bool stroke = false;
};

/// A double stroke as the table of MODEL-5 prints it, top to bottom, left to right.
std::vector<Line> table(const Project& p, double axialFeed, int plungeIn, int n1, int n2) {
    const double b1 = p.wheel->width_mm - p.machine->overrun_entry_mm;
    const double b2 = p.wheel->width_mm - p.machine->overrun_exit_mm;
    const double b = std::min(axialFeed / p.machine->work_speed_rpm, p.wheel->width_mm);
    return {{Zone::rz1, Step::e1, plungeIn, b1}, {Zone::rz1, Step::e2, n1, b1},
            {Zone::rz1, Step::e3, 1, b, true},   {Zone::nz, Step::e1, 1, b, true},
            {Zone::rz2, Step::e1, 1, b, true},   {Zone::rz2, Step::e2, n2, b2},
            {Zone::rz1, Step::e4, 1, b, true},   {Zone::nz, Step::e2, 1, b, true},
            {Zone::rz2, Step::e3, 1, b, true},   {Zone::rz1, Step::e5, n1, b1}};
}

double travel(const Project& p) {
    return p.part->length_mm - p.wheel->width_mm + p.machine->overrun_entry_mm
           + p.machine->overrun_exit_mm;
}

/// One stage of so many double strokes: position control, so that the stock sets their number.
Project strokes(int count, double radialFeed_mm, double axialFeed_mm_min = 1800) {
    Project p = fixtures::traverse();
    p.gauge->control = Control::position;
    p.part->initial_runout_mm = 0;
    p.part->stock_mm = count * radialFeed_mm;
    p.cycle->stages = {strokeStage(radialFeed_mm, axialFeed_mm_min, p.part->stock_mm)};
    return p;
}

int passesOf(const Traced& run, int doubleStroke, Zone zone, Step step) {
    return int(std::count_if(run.trajectory.passes.begin(), run.trajectory.passes.end(),
                             [&](const Pass& pass) {
                                 return pass.place.cycleCount == doubleStroke
                                        && pass.place.zone == zone && pass.place.step == step;
                             }));
}

/// A spark-out that never gets done: the feed stops 10 µm before size.
Project stalling() {
    Project p = strokes(10, 0.005);
    p.wheel->dullness = 0; // removal dies away like r^m, not like 1/m²
    p.part->stock_mm += 0.01;
    p.cycle->stages.push_back(sparkStage(fixtures::untilSize(), 0.01, 1800));
    return p;
}

/// More visits than a run may have.
Project endless() {
    Project p = strokes(1, 0.005);
    p.part->radii_per_section = 360;
    p.machine->dwell_entry_s = 3;
    p.cycle->stages.push_back(sparkStage(fixtures::count(100'000), 0, 1800));
    return p;
}

class TestTraverseCycle : public QObject {
    Q_OBJECT

private slots:
    void doubleStrokeGoesThroughTheStepsInTheOrderOfTheTable_data() {
        QTest::addColumn<double>("dwellEntry_s"); // n = 180: a revolution takes a third of a second
        addColumns<double, double, double>("dwellExit_s", "radialFeed_mm", "axialFeed_mm_min");
        QTest::addColumn<int>("plungeIn"); // 180·S_t/0.5
        addColumns<int, int>("n1", "n2");
        QTest::newRow("dwells") << 1.0 << 0.667 << 0.004 << 1800.0 << 2 << 3 << 2;
        QTest::newRow("no dwell") << 0.0 << 0.0 << 0.001 << 300.0 << 1 << 0 << 0;
        QTest::newRow("entry dwell only") << 0.334 << 0.0 << 0.01 << 1800.0 << 4 << 1 << 0;
        QTest::newRow("exit dwell only") << 0.0 << 0.334 << 0.0125 << 1800.0 << 5 << 0 << 1;
        QTest::newRow("wider than the wheel") << 0.4 << 0.4 << 0.004 << 10'000.0 << 2 << 1 << 1;
    }
    void doubleStrokeGoesThroughTheStepsInTheOrderOfTheTable() {
        QFETCH(double, dwellEntry_s);
        QFETCH(double, dwellExit_s);
        QFETCH(double, radialFeed_mm);
        QFETCH(double, axialFeed_mm_min);
        QFETCH(int, plungeIn);
        QFETCH(int, n1);
        QFETCH(int, n2);
        Project p = strokes(4, radialFeed_mm, axialFeed_mm_min);
        p.machine->dwell_entry_s = dwellEntry_s;
        p.machine->dwell_exit_s = dwellExit_s;
        const Traced run(p);
        QCOMPARE(run.result.cycleCount, 4);
        const double revolution = 60.0 / 180;
        const double stroke = travel(p) / axialFeed_mm_min * 60;
        std::size_t next = 0;
        double time = 0;
        for (int z = 1; z <= 4; ++z) {
            const double before = (z - 1) * radialFeed_mm;
            for (const Line& line : table(p, axialFeed_mm_min, plungeIn, n1, n2)) {
                for (int m = 1; m <= line.passes; ++m) {
                    QVERIFY(next < run.trajectory.passes.size());
                    const Pass& pass = run.trajectory.passes[next++];
                    QCOMPARE(pass.place.zone, line.zone);
                    QCOMPARE(pass.place.section, int(line.zone));
                    QCOMPARE(pass.place.step, line.step);
                    QCOMPARE(pass.place.revolution, m);
                    QCOMPARE(pass.place.cycleCount, z);
                    QCOMPARE(pass.place.stage, 1);
                    QCOMPARE(pass.effectiveWidth_mm, line.width);
                    QCOMPARE(pass.axialFeed_mm_min, line.stroke ? axialFeed_mm_min : 0);
                    QVERIFY(close(pass.radialFeed_mm, radialFeed_mm,
                                  1e-12)); // the last may be cut short by a bit
                    // Three zones share a stroke: its time runs on after РЗ2's pass.
                    const double duration = line.stroke ? stroke : revolution;
                    QVERIFY(within(pass.start_s, time, 1e-12 * (time + 1)));
                    QVERIFY(close(pass.duration_s, duration, 1e-15));
                    for (int k = 0; k < run.trajectory.radii; ++k) {
                        const double share = (k + 1.0) / run.trajectory.radii;
                        const bool e1 = line.zone == Zone::rz1 && line.step == Step::e1;
                        const double fed = e1 ? std::min(radialFeed_mm, 0.5 / 180 * (m - 1 + share))
                                              : radialFeed_mm;
                        const Visit& visit = run.visit(pass, k);
                        QVERIFY(
                            within(visit.programmed_mm, before + fed, fixtures::rounding(0.1, z)));
                        QVERIFY(within(visit.time_s, time + duration * (line.stroke ? 1 : share),
                                       1e-12 * (time + 1)));
                    }
                    if (!line.stroke || line.zone == Zone::rz2) {
                        time += duration;
                    }
                }
            }
        }
        QCOMPARE(next, run.trajectory.passes.size());
        // MODEL-5: (N_E1 + 2·N1 + N2)/n + 2·travel/S_ax a double stroke
        const double whole = 4 * ((plungeIn + 2 * n1 + n2) * revolution + 2 * stroke);
        QVERIFY(close(run.result.time_s, whole, 1e-14));
        QVERIFY(within(run.result.time_s, time, 1e-12 * time));
    }

    // ⌊x + 0.5 + 1e-9⌋, at least 1 when there is a dwell; n = 60, so seconds are revolutions.
    void dwellIsRoundedToWholeRevolutions_data() {
        addColumns<double, int>("dwell_s", "revolutions");
        QTest::newRow("none") << 0.0 << 0;
        QTest::newRow("a little") << 0.001 << 1;
        QTest::newRow("less than a half") << 0.49 << 1;
        QTest::newRow("one") << 1.0 << 1;
        QTest::newRow("just below one and a half") << 1.499999 << 1;
        QTest::newRow("inside the slack") << 1.5 - 0.9e-9 << 2;
        QTest::newRow("outside the slack") << 1.5 - 1.1e-9 << 1;
        QTest::newRow("one and a half") << 1.5 << 2;
        QTest::newRow("two and a half") << 2.5 << 3;
        QTest::newRow("many") << 17.2 << 17;
    }
    void dwellIsRoundedToWholeRevolutions() {
        QFETCH(double, dwell_s);
        QFETCH(int, revolutions);
        Project p = strokes(2, 0.005);
        p.machine->work_speed_rpm = 60;
        p.machine->dwell_entry_s = dwell_s;
        p.machine->dwell_exit_s = 0;
        const Traced entry(p);
        QCOMPARE(passesOf(entry, 1, Zone::rz1, Step::e2), revolutions);
        QCOMPARE(passesOf(entry, 1, Zone::rz1, Step::e5), revolutions);
        QCOMPARE(passesOf(entry, 1, Zone::rz2, Step::e2), 0);
        std::swap(p.machine->dwell_entry_s, p.machine->dwell_exit_s);
        const Traced exit(p);
        QCOMPARE(passesOf(exit, 2, Zone::rz2, Step::e2), revolutions);
        QCOMPARE(passesOf(exit, 2, Zone::rz1, Step::e2), 0);
        QCOMPARE(passesOf(exit, 2, Zone::rz1, Step::e5), 0);
    }

    // N_E1 = ⌈n·S_t/S_rad − 1e-9⌉
    void plungeInTakesAsManyRevolutionsAsItsFeedNeeds_data() {
        QTest::addColumn<double>("ratio"); // n·S_t/S_rad
        QTest::addColumn<int>("revolutions");
        QTest::newRow("a fraction of one") << 0.2 << 1;
        QTest::newRow("one") << 1.0 << 1;
        QTest::newRow("inside the slack") << 1 + 0.9e-9 << 1;
        QTest::newRow("outside the slack") << 1 + 1.1e-9 << 2;
        QTest::newRow("three and a bit") << 3.001 << 4;
        QTest::newRow("seven") << 7.0 << 7;
    }
    void plungeInTakesAsManyRevolutionsAsItsFeedNeeds() {
        QFETCH(double, ratio);
        QFETCH(int, revolutions);
        Project p = strokes(2, 0.005);
        p.machine->plunge_feed_mm_min = 180 * 0.005 / ratio;
        QCOMPARE(passesOf(Traced(p), 1, Zone::rz1, Step::e1), revolutions);
    }

    void sparkOutStrokesHaveNoPlungeInAndFeedNothing() {
        Project p = strokes(3, 0.005);
        p.cycle->stages.push_back(sparkStage(fixtures::count(2), 0, 600));
        const Traced run(p);
        QCOMPARE(run.result.countsByStage, (std::vector<int>{3, 2}));
        for (int stroke = 4; stroke <= 5; ++stroke) {
            QCOMPARE(passesOf(run, stroke, Zone::rz1, Step::e1), 0);
            QCOMPARE(passesOf(run, stroke, Zone::nz, Step::e1), 1);
        }
        for (const Pass& pass : run.trajectory.passes) {
            if (pass.place.cycleCount > 3) {
                QCOMPARE(pass.place.stage, 2);
                QCOMPARE(pass.radialFeed_mm, 0.0);
                QVERIFY(within(run.visit(pass, 0).programmed_mm, 0.015, 1e-16));
            }
        }
        // the second stage's strokes run at its own axial feed
        const double dwells = (2 * 1 + 2) * 60.0 / 180;
        QVERIFY(close(run.result.timeByStage_s[1], 2 * (dwells + 2 * travel(p) / 600 * 60), 1e-14));
    }

    // The last step of a stage under position control is cut short, and so is its plunge-in.
    void positionControlCutsTheLastPlungeInShort() {
        Project p = strokes(3, 0.01); // four revolutions of plunge-in
        p.part->stock_mm = 0.024;
        p.cycle->stages[0].stock_mm = 0.024;
        const Traced run(p);
        QCOMPARE(run.result.cycleCount, 3);
        QCOMPARE(passesOf(run, 2, Zone::rz1, Step::e1), 4);
        QCOMPARE(passesOf(run, 3, Zone::rz1, Step::e1), 2); // 180·0.004/0.5 = 1.44
        QVERIFY(within(run.trajectory.passes.back().radialFeed_mm, 0.004, 1e-16));
        QVERIFY(within(run.trajectory.visits.back().programmed_mm, 0.024, 1e-16));
    }

    // The gauge stands in the middle of НЗ and is read after the double stroke.
    void gaugeIsReadInTheNonReversalZoneAfterTheStroke() {
        Project p = fixtures::traverse();
        const Traced run(p);
        const auto& R = run.result.sections[1].radii_mm;
        double smallest = 1e9;
        for (std::size_t k = 0; k < 6; ++k) {
            smallest = std::min(smallest, R[k] + R[k + 6]);
        }
        QVERIFY(within(run.result.gaugeReading_mm, smallest, 64 * fixtures::epsilon));
        QCOMPARE(run.result.status, RunStatus::completed);
        QCOMPARE(run.trajectory.passes.back().place.step, Step::e5); // the last stroke is whole
    }

    void zonesLieWhereTheWheelReverses_data() {
        QTest::addColumn<EntrySide>("side");
        QTest::newRow("entry at the headstock") << EntrySide::headstock;
        QTest::newRow("entry at the tailstock") << EntrySide::tailstock;
    }
    void zonesLieWhereTheWheelReverses() {
        QFETCH(EntrySide, side);
        Project p = fixtures::traverse();
        p.machine->overrun_entry_mm = 10;
        p.machine->overrun_exit_mm = 20; // РЗ1 40, РЗ2 30, НЗ 22 of 92 mm
        p.machine->entry_side = side;
        const SimulationResult r = simulateUnchecked(p);
        const bool headstock = side == EntrySide::headstock;
        QVERIFY(within(r.sections[0].position_mm, headstock ? 20 : 72, 1e-13));
        QVERIFY(within(r.sections[1].position_mm, headstock ? 51 : 41, 1e-13));
        QVERIFY(within(r.sections[2].position_mm, headstock ? 77 : 15, 1e-13));
        QCOMPARE(r.sections[0].zone, Zone::rz1);
        QCOMPARE(r.sections[1].zone, Zone::nz);
        QCOMPARE(r.sections[2].zone, Zone::rz2);
    }

    // Equal compliance: РЗ1 is cut most often at the wheel's own feed, НЗ least (MODEL-10's order
    // НЗ > РЗ2 > РЗ1 for ordinary inputs).
    void zonesEndInTheOrderOfTheSources() {
        Project p = fixtures::traverse();
        p.machine->compliance_mm_per_n = ZoneCompliance{1.5e-4, 1.5e-4, 1.5e-4};
        p.machine->dwell_exit_s = 0.333;
        const SimulationResult r = simulateUnchecked(p);
        QVERIFY(r.sections[1].diameterDeviationMax_mm > r.sections[2].diameterDeviationMax_mm);
        QVERIFY(r.sections[2].diameterDeviationMax_mm > r.sections[0].diameterDeviationMax_mm);
    }

    void plainRunAllocatesNothingPerStroke() {
        const auto allocationsOf = [](int count) {
            Project p = strokes(5, 0.005);
            p.cycle->stages.push_back(sparkStage(fixtures::count(count - 5), 0, 1800));
            const long long before = allocations::count;
            const SimulationResult r = simulateUnchecked(p);
            const long long used = allocations::count - before;
            return r.cycleCount == count ? used : -count;
        };
        const long long used = allocationsOf(100);
        QVERIFY(used > 0); // the counter counts
        QCOMPARE(allocationsOf(1000), used);
    }

    void feedingStrokesAllocateNothingEither() {
        const auto allocationsOf = [](int count) {
            const Project p = strokes(count, 0.0002);
            const long long before = allocations::count;
            const SimulationResult r = simulateUnchecked(p);
            const long long used = allocations::count - before;
            return r.cycleCount == count ? used : -count;
        };
        QCOMPARE(allocationsOf(1000), allocationsOf(100));
    }

    // Of use twice: what was in it before is gone.
    void trajectoryOfAnEarlierRunIsForgotten() {
        Trajectory trajectory;
        (void)simulateUnchecked(strokes(3, 0.005), &trajectory);
        const std::size_t visits = trajectory.visits.size();
        (void)simulateUnchecked(strokes(3, 0.005), &trajectory);
        QCOMPARE(trajectory.visits.size(), visits);
    }

    void sparkOutThatReachesSizeEndsWithTheReading() {
        Project p = fixtures::traverse();
        p.part->stock_mm = 0.12;
        // 0.5 µm a double stroke leaves a deflection of some 2 µm, of which the spark-out takes up
        // to 1.
        p.cycle->stages = {strokeStage(0.0005, 1800, 0.119),
                           sparkStage(fixtures::untilSize(), 0.001, 1800)};
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.status, RunStatus::completed);
        QVERIFY(r.countsByStage[1] >= 1);
        QVERIFY(r.remainingStock_mm <= 1e-9);
    }

    // MODEL-7: it ends with a clear error that states the size reached; it never loops.
    void sparkOutThatStallsEndsAndSaysWhereItStands() {
        const Traced run(stalling());
        const SimulationResult& r = run.result;
        QCOMPARE(r.status, RunStatus::cannotReachSize);
        QVERIFY(r.cycleCount > 11);
        // Everything fed is cut but a deflection that gives less than 1e-9 mm a stroke, each of
        // two passes: at most A times that remains, A = 1 + γ·b·k_s < 10.
        QVERIFY(r.remainingStock_mm >= 0.01 - 1e-15 && r.remainingStock_mm < 0.01 + 1e-8);
        QVERIFY(within(r.gaugeReading_mm / 2, targetRadius(*r.project.part) + r.remainingStock_mm,
                       64 * fixtures::epsilon));
        // It ended at the first double stroke without removal.
        std::vector<double> most(std::size_t(r.cycleCount));
        for (const Pass& pass : run.trajectory.passes) {
            double& ofStroke = most[std::size_t(pass.place.cycleCount) - 1];
            for (int k = 0; k < run.trajectory.radii; ++k) {
                ofStroke = std::max(ofStroke, run.visit(pass, k).actual_mm);
            }
        }
        QVERIFY(most.back() <= 1e-9);
        QVERIFY(most[most.size() - 2] > 1e-9);
    }

    void stopRequestedBeforehandEndsBeforeTheFirstStroke() {
        const StoppedSource source;
        const SimulationResult r =
            simulateUnchecked(fixtures::traverse(), nullptr, source.get_token());
        QCOMPARE(r.status, RunStatus::stopped);
        QCOMPARE(r.cycleCount, 0);
        QCOMPARE(r.visits, 0LL);
        QCOMPARE(r.sections.size(), std::size_t(3)); // the blank as it stands
    }

    // 100 ms is the target for a cancelled run; a test fails at four times that.
    void stopRequestEndsARunUnderWay() {
        std::stop_source source;
        std::chrono::steady_clock::time_point requested{};
        std::jthread asker([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            requested = std::chrono::steady_clock::now();
            source.request_stop();
        });
        const SimulationResult r = simulateUnchecked(endless(), nullptr, source.get_token());
        const auto ended = std::chrono::steady_clock::now();
        asker.join();
        if (r.status == RunStatus::stopped) {
            QVERIFY(ended - requested < std::chrono::milliseconds(400));
            QVERIFY(r.visits < maxVisits + 360 * 7);
        } else { // the run was through its visits before the request came
            QVERIFY(ended <= requested);
        }
    }

    void runWithTooManyVisitsEnds() {
        const SimulationResult r = simulateUnchecked(endless());
        QCOMPARE(r.status, RunStatus::tooLong);
        // Looked at before every revolution; the two strokes of three zones may still follow.
        QVERIFY(r.visits > maxVisits && r.visits <= maxVisits + 360 * 7);
        // (2·N1 + N2 + 6) passes a double stroke, N_E1 = 2 more in the first
        QCOMPARE(r.cycleCount, int((maxVisits - 360 * 2) / (360 * (2 * 9 + 2 + 6))));
    }

    // One double stroke of 600,000 revolutions of dwell is too long in itself.
    void longestDwellIsNotWaitedFor() {
        Project p = strokes(2, 0.005);
        p.part->radii_per_section = 360;
        p.machine->work_speed_rpm = 10'000;
        p.machine->dwell_entry_s = 3600;
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.status, RunStatus::tooLong);
        QVERIFY(r.visits <= maxVisits + 360 * 7);
        QCOMPARE(r.cycleCount, 0);
    }
};

} // namespace sparkout::test_traverse_cycle

SPARKOUT_TEST(test_traverse_cycle, TestTraverseCycle)
#include "test_traverse_cycle.moc"
