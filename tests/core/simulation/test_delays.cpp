// SPDX-License-Identifier: GPL-3.0-or-later
// Delays of gauge and machine [MODEL-7]: what they add to a stage, and what they leave alone.
#include "core/simulation/stage_control.h"

#include "tests/core/simulation/random_cycles.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_delays {

using namespace random_cycles;

Project delayed(Project p, double gauge_s, double change_s) {
    p.gauge->delay_s = gauge_s;
    p.machine->feed_change_delay_s = change_s;
    return p;
}

Project byGauge(Project p) {
    p.gauge->control = Control::gauge;
    return p;
}

/// How many steps of the time T a delay lasts.
int stepsOf(double delay_s, double step_s) {
    return static_cast<int>(std::ceil(delay_s / step_s - 1e-6));
}

/// A delay that is not a number of steps, so that no last bit decides.
double anyDelay(double step_s) {
    return (pick(0, 6) + between(0.05, 0.95)) * step_s;
}

double revolution_s(const Project& p) {
    return 60 / p.machine->work_speed_rpm;
}

/// Two stages that feed, the second with so much stock that it is long.
Project longCycle(bool traverse) {
    Project p = traverse ? fixtures::traverse() : fixtures::plunge();
    p.cycle->stages =
        traverse ? std::vector{fixtures::strokeStage(0.004, 1800, 0.08),
                               fixtures::strokeStage(0.001, 900, 0.07)}
                 : std::vector{fixtures::plungeStage(0.9, 0.1), fixtures::plungeStage(0.2, 0.1)};
    p.part->stock_mm = traverse ? 0.15 : 0.2;
    return p;
}

/// T of the stages of a run.
double stepTime_s(const SimulationResult& run, std::size_t stage) {
    return run.timeByStage_s[stage] / run.countsByStage[stage];
}

class TestDelays : public QObject {
    Q_OBJECT

private slots:
    void noDelayChangesNothingToTheBit() {
        QVERIFY(holds("delays of zero", [] {
            const Project p = anyCycle();
            RC_ASSERT(
                fixtures::sameBits(simulateUnchecked(p), simulateUnchecked(delayed(p, 0, 0))));
        }));
    }

    // ⌈τ/T⌉ steps more, each as the stage's own; the gauge's delay on all stages, the feed change's
    // on all but the last.
    void aStageGoesOnForTheStepsThatTheDelayLasts() {
        for (const bool traverse : {false, true}) {
            const Project p = longCycle(traverse);
            const SimulationResult prompt = simulateUnchecked(p);
            const double first_s = stepTime_s(prompt, 0), last_s = stepTime_s(prompt, 1);
            for (const double gauge : {0.0, 0.3, 1.0, 1.4, 3.0}) {
                for (const double change : {0.0, 0.5, 1.0, 2.2}) {
                    const double gauge_s = gauge * first_s, change_s = change * first_s;
                    const SimulationResult late = simulateUnchecked(delayed(p, gauge_s, change_s));
                    QCOMPARE(late.countsByStage[0],
                             prompt.countsByStage[0] + stepsOf(gauge_s + change_s, first_s));
                    QVERIFY(fixtures::close(stepTime_s(late, 0), first_s, 1e-12));
                    // with the second stage alone before it, its own steps count
                    const SimulationResult same =
                        simulateUnchecked(delayed(p, 0, gauge_s + change_s));
                    QCOMPARE(late.countsByStage[0], same.countsByStage[0]);
                    QCOMPARE(late.countsByStage[1],
                             same.countsByStage[1] + stepsOf(gauge_s, last_s));
                }
            }
        }
    }

    void aCycleOfOneStageGoesOnForTheGaugeAlone() {
        QVERIFY(holds("one stage", [] {
            Project p = byGauge(anyPlunge());
            p.cycle->stages.resize(1);
            const double step_s = revolution_s(p), gauge_s = anyDelay(step_s);
            const SimulationResult prompt = simulateUnchecked(p);
            RC_PRE(prompt.status == RunStatus::completed);
            RC_ASSERT(fixtures::sameBits(prompt, simulateUnchecked(delayed(p, 0, 20))));
            const SimulationResult late = simulateUnchecked(delayed(p, gauge_s, 3));
            RC_ASSERT(late.cycleCount == prompt.cycleCount + stepsOf(gauge_s, step_s));
            RC_ASSERT(late.remainingStock_mm <= prompt.remainingStock_mm);
        }));
    }

    // The first one's end changes the name of the stage and nothing else: what the pruned search
    // rests on.
    void twoStagesWithOneFeedAreOneStage() {
        QVERIFY(holds("equal neighbours", [] {
            Project p = byGauge(anyCycle());
            p.cycle->stages.resize(1);
            const Stage stage = p.cycle->stages.front();
            const int others = pick(1, 3); // stages behind both, or none
            Stage slow = stage;
            for (auto feed : {&Stage::radial_feed_mm, &Stage::radial_feed_mm_min}) {
                slow.*feed = slow.*feed ? std::optional(*(slow.*feed) / 2) : std::nullopt;
            }
            Project whole = p;
            whole.cycle->stages.assign(1, stage);
            whole.cycle->stages.front().stock_mm = 0.7 * p.part->stock_mm;
            whole.cycle->stages.insert(whole.cycle->stages.end(), std::size_t(others - 1), slow);
            Project split = whole;
            split.cycle->stages.insert(split.cycle->stages.begin(), stage);
            split.cycle->stages[0].stock_mm = between(0.1, 0.6) * p.part->stock_mm;
            split.cycle->stages[1].stock_mm -= split.cycle->stages[0].stock_mm;
            const double most_s = p.operation == Operation::plunge ? 5 * revolution_s(p) : 20;
            const double gauge_s = between(0, most_s), change_s = between(0, most_s);
            const SimulationResult a = simulateUnchecked(delayed(whole, gauge_s, change_s));
            const SimulationResult b = simulateUnchecked(delayed(split, gauge_s, change_s));
            RC_ASSERT(a.cycleCount == b.cycleCount && a.time_s == b.time_s);
            for (std::size_t i = 0; i < a.sections.size(); ++i) {
                RC_ASSERT(a.sections[i].radii_mm == b.sections[i].radii_mm);
            }
        }));
    }

    // Thresholds that are crossed within one delay count each from its own reading: by the readings
    // of the trace, whatever stage was running when the command came.
    void severalThresholdsWithinOneDelayCountEachFromItsReading() {
        int within = 0, skipped = 0;
        for (int seed = 0; seed < 60; ++seed) {
            Project p = fixtures::plunge();
            const double second_mm = 0.002 + 0.0013 * (seed % 7), third_mm = 0.001 * (seed % 4);
            p.cycle->stages = {fixtures::plungeStage(0.9, 0.2 - second_mm - third_mm - 0.03),
                               fixtures::plungeStage(0.6, second_mm),
                               fixtures::plungeStage(0.3, third_mm),
                               fixtures::plungeStage(0.1, 0.03)};
            const double turn_s = revolution_s(p);
            const double gauge_s = turn_s * 0.37 * (seed % 5),
                         change_s = turn_s * (seed % 6 + 0.21);
            const fixtures::Traced run(delayed(p, gauge_s, change_s));
            std::vector<double> left_mm; // after each revolution
            for (const Pass& pass : run.trajectory.passes) {
                double least_mm = 1e9;
                for (int k = 0; k < 2; ++k) {
                    least_mm = std::min(least_mm, run.visit(pass, k).radius_mm
                                                      + run.visit(pass, k + 2).radius_mm);
                }
                left_mm.push_back(least_mm / 2 - targetRadius(*p.part));
            }
            double later_mm = 0.2;
            int last = 0;
            std::vector<int> counts;
            for (std::size_t z = 0; z < 4; ++z) {
                later_mm -= p.cycle->stages[z].stock_mm;
                const double delay_s = z < 3 ? gauge_s + change_s : gauge_s;
                const auto endsBy = [&](int step, double threshold_mm, double late_s) {
                    for (int read = 1; read <= step; ++read) {
                        if (left_mm[std::size_t(read - 1)] <= threshold_mm + 1e-9
                            && read * turn_s + late_s <= step * turn_s + 1e-9) {
                            return true;
                        }
                    }
                    return false;
                };
                int end = std::max(last, 1);
                while (!endsBy(end, later_mm, delay_s) && !endsBy(end, 0, gauge_s)) {
                    ++end;
                }
                counts.push_back(end - last);
                within += z == 1 && end - last < stepsOf(delay_s, turn_s) ? 1 : 0;
                skipped += end == last ? 1 : 0;
                last = end;
            }
            QVERIFY(run.result.countsByStage == counts);
        }
        QVERIFY(within > 10 && skipped > 5);
    }

    // Drawing the wheel back is no change of feed: where the size is read while the change is
    // delayed, the cycle is that of the first feed alone.
    void theCommandAtSizeEndsAnyStage() {
        for (const bool traverse : {false, true}) {
            const Project p = longCycle(traverse);
            Project one = p;
            one.cycle->stages.resize(1);
            const SimulationResult first = simulateUnchecked(delayed(one, 0.7, 0));
            const SimulationResult late = simulateUnchecked(delayed(p, 0.7, 1e4));
            QCOMPARE(late.status, RunStatus::completed);
            QCOMPARE(late.countsByStage[0], first.countsByStage[0]);
            QCOMPARE(late.countsByStage[1], 0);
            for (std::size_t i = 0; i < late.sections.size(); ++i) {
                QVERIFY(late.sections[i].radii_mm == first.sections[i].radii_mm);
            }
        }
    }

    void positionKnowsItsOwnEnd() {
        QVERIFY(holds("position control", [] {
            Project p = anyCycle();
            p.gauge->control = Control::position;
            RC_ASSERT(
                fixtures::sameBits(simulateUnchecked(p), simulateUnchecked(delayed(p, 2, 3))));
        }));
    }

    void aSparkOutByNumberIsCounted() {
        for (const bool traverse : {false, true}) {
            Project p = longCycle(traverse);
            p.cycle->stages.push_back(p.cycle->stages.back());
            p.cycle->stages.back().sparkOutFor(4);
            p.cycle->stages.back().stock_mm = 0;
            const SimulationResult late = simulateUnchecked(delayed(p, 2, 1));
            QCOMPARE(late.status, RunStatus::completed);
            QCOMPARE(late.countsByStage[2], 4);
        }
    }

    // One until size waits for the command, and is not stuck though it removes nothing meanwhile.
    void aSparkOutUntilSizeWaitsForItsCommand() {
        for (const bool traverse : {false, true}) {
            Project p = longCycle(traverse);
            p.gauge->control = Control::position;
            p.wheel->dullness = 0; // else the size is never quite reached
            p.cycle->stages.push_back(p.cycle->stages.back());
            p.cycle->stages.back().sparkOutUntilSize();
            p.cycle->stages.back().stock_mm = 0;
            const SimulationResult prompt = simulateUnchecked(p);
            QCOMPARE(prompt.status, RunStatus::completed);
            QVERIFY(prompt.countsByStage[2] > 0);
            const SimulationResult late = simulateUnchecked(delayed(p, 60, 0));
            QCOMPARE(late.status, RunStatus::completed);
            QCOMPARE(late.countsByStage[2],
                     prompt.countsByStage[2] + stepsOf(60, stepTime_s(prompt, 2)));
            // Drawing the wheel back is no change of feed.
            QCOMPARE(simulateUnchecked(delayed(p, 60, 90)).countsByStage[2], late.countsByStage[2]);
            p.cycle->stages.back().stock_mm = 0.001; // what is fed is less than the stock
            const SimulationResult stuck = simulateUnchecked(delayed(p, 60, 0));
            QCOMPARE(stuck.status, RunStatus::cannotReachSize);
        }
    }

    // Readings at 1, 2, 3 … s; the delays run side by side.
    void delaysOfSeveralReadingsRunSideBySide() {
        Project p = fixtures::plunge();
        p.gauge->delay_s = 1.5;
        p.machine->feed_change_delay_s = 1;
        GaugeSignal signal(p, true);
        QVERIFY(!signal.isOver(1, false) && signal.dueBy(1) < 0); // nothing was read
        const double read[] = {0.09, 0.04, 0.03, 0.01, 0, -0.01, -0.02, -0.03};
        const auto since = [&](double later_mm, bool last) {
            GaugeSignal again(p, true);
            for (int i = 0; i < 8; ++i) {
                again.read(i + 1, read[i]);
                if (again.isOver(later_mm, last)) {
                    return i + 1;
                }
            }
            return 0;
        };
        QCOMPARE(since(0.05, false), 5); // read at 2, known at 4.5
        QCOMPARE(since(0.035, false), 6);
        QCOMPARE(since(0.01, false), 7); // read at 4, known at 6.5; size at 5, known at 6.5
        QCOMPARE(since(0.001, false), 7);
        QCOMPARE(since(0, true), 7);
        p.machine->feed_change_delay_s = 4;
        QCOMPARE(since(0.05, false), 7); // by the size; 8 without
        p.gauge->delay_s = 3;
        p.machine->feed_change_delay_s.reset();
        QCOMPARE(since(0.04, false), 5); // to the second: read at 2, known at 5
        QVERIFY(std::isinf(GaugeSignal(p, true).known_mm()));
        GaugeSignal known(p, true);
        for (int i = 0; i < 8; ++i) {
            known.read(i + 1, read[i]);
        }
        QVERIFY(std::abs(known.known_mm() - 0) < 1e-15); // read at 5, three seconds before
    }

    // The machine's delay is that of a gauge for which none is given; a given one replaces it.
    void theMachinesGaugeIsAsLateAsOneOfItsOwn() {
        for (const bool traverse : {false, true}) {
            const Project prompt = byGauge(longCycle(traverse));
            Project own = prompt, ofMachine = prompt, both = prompt;
            own.gauge->delay_s = ofMachine.machine->gauge_delay_s =
                2.2 * stepTime_s(simulateUnchecked(prompt), 0);
            both.machine->gauge_delay_s = ofMachine.machine->gauge_delay_s;
            both.gauge->delay_s = 0;
            const SimulationResult late = simulateUnchecked(ofMachine);
            QCOMPARE(late.countsByStage, simulateUnchecked(own).countsByStage);
            QCOMPARE(late.time_s, simulateUnchecked(own).time_s);
            QVERIFY(late.countsByStage != simulateUnchecked(prompt).countsByStage);
            QCOMPARE(simulateUnchecked(both).time_s, simulateUnchecked(prompt).time_s);
        }
    }
};

} // namespace sparkout::test_delays

SPARKOUT_TEST(test_delays, TestDelays)
#include "test_delays.moc"
