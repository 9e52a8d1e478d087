// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/simulate.h"

#include "tests/core/support/allocation_counter.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

namespace sparkout::test_plunge_cycle {

using fixtures::close;
using fixtures::plungeStage;
using fixtures::sparkStage;
using fixtures::Traced;
using fixtures::within;

/// So many revolutions at 5 µm; position control, so that the stock sets their number.
Project revolutions(int count) {
    Project p = fixtures::plunge();
    p.gauge->control = Control::position;
    p.part->stock_mm = 0.005 * count;
    p.cycle->stages[0].stock_mm = p.part->stock_mm;
    return p;
}

void setGammas(Project& p, std::vector<double> gammas) {
    p.sections = int(gammas.size());
    p.machine->compliance_mm_per_n = std::move(gammas);
}

/// What the gauge reads by the rule `min` of these radii of a shaft.
double smallestDiameter(const std::vector<double>& R) {
    double smallest = 1e9;
    for (std::size_t k = 0; k < R.size() / 2; ++k) {
        smallest = std::min(smallest, R[k] + R[k + R.size() / 2]);
    }
    return smallest;
}

class TestPlungeCycle : public QObject {
    Q_OBJECT

private slots:
    // t_П + (S_p/n)·(k+1)/K for radius k, in every section; after the revolution t_П += S_p/n.
    void infeedIsARampOverTheRevolution_data() {
        QTest::addColumn<int>("radii");
        QTest::newRow("4 radii") << 4;
        QTest::newRow("36 radii") << 36;
    }
    void infeedIsARampOverTheRevolution() {
        QFETCH(int, radii);
        Project p = revolutions(20);
        p.part->radii_per_section = radii;
        setGammas(p, {2e-5, 4e-5, 1e-5});
        const Traced run(p);
        QCOMPARE(run.result.cycleCount, 20);
        QCOMPARE(run.trajectory.passes.size(), std::size_t(60));
        for (std::size_t i = 0; i < 60; ++i) {
            const Pass& pass = run.trajectory.passes[i];
            const int m = int(i) / 3;
            QCOMPARE(pass.place.section, int(i) % 3); // from the headstock on
            QCOMPARE(pass.place.cycleCount, m + 1);
            QCOMPARE(pass.place.stage, 1);
            QCOMPARE(pass.place.step, Step::none);
            QCOMPARE(pass.place.zone, Zone::section);
            QCOMPARE(pass.effectiveWidth_mm, 40.0);
            QCOMPARE(pass.axialFeed_mm_min, 0.0);
            QVERIFY(close(pass.duration_s, 60.0 / 180, 1e-15));
            QVERIFY(within(pass.start_s, m * 60.0 / 180, 1e-13));
            for (int k = 0; k < radii; ++k) {
                const double share = (k + 1.0) / radii;
                const Visit& visit = run.visit(pass, k);
                QVERIFY(
                    within(visit.programmed_mm, 0.005 * (m + share), fixtures::rounding(0.1, m)));
                QVERIFY(within(visit.time_s, (m + share) * 60 / 180, 1e-13));
            }
        }
    }

    // A rigid shaft ends as the infeed's spiral: radius k stands (K−1−k)/K of a revolution's feed
    // above the last one, less what γ·P_y(h) holds back.
    void rigidShaftEndsAsTheSpiralOfTheInfeed() {
        Project p = revolutions(20);
        setGammas(p, {1e-15});
        const SimulationResult r = simulateUnchecked(p);
        const auto& R = r.sections[0].radii_mm;
        for (std::size_t k = 0; k < 4; ++k) {
            QVERIFY(within(R[k] - R[3], 0.005 * double(3 - k) / 4,
                           1e-15 * 1000 + 16 * fixtures::epsilon));
        }
    }

    void cycleTimeIsTheRevolutionsOverTheSpeed() {
        for (const int count : {1, 7, 200}) {
            const SimulationResult r = simulateUnchecked(revolutions(count));
            QCOMPARE(r.cycleCount, count);
            QVERIFY(close(r.time_s, count * 60.0 / 180, fixtures::epsilon * (count + 2)));
        }
    }

    void stagesFeedAtTheirOwnRate() {
        Project p = revolutions(20);
        p.part->stock_mm = 0.13;
        p.cycle->stages = {plungeStage(1.8, 0.1), plungeStage(0.36, 0.03),
                           sparkStage(fixtures::count(5))};
        const Traced run(p);
        QCOMPARE(run.result.countsByStage, (std::vector<int>{10, 15, 5}));
        const double feeds[] = {0.01, 0.002, 0};
        for (const Pass& pass : run.trajectory.passes) {
            // a stage's last step ends on its threshold, off by the rounding of t_П
            QVERIFY(within(pass.radialFeed_mm, feeds[pass.place.stage - 1], 1e-15));
        }
        QVERIFY(within(run.trajectory.visits.back().programmed_mm, 0.13, 1e-16));
        QVERIFY(close(run.result.timeByStage_s[1], 15 * 60.0 / 180, 1e-14));
    }

    void positionControlCutsTheLastRevolutionShort() {
        Project p = revolutions(10);
        p.part->stock_mm = 0.048;
        p.cycle->stages[0].stock_mm = 0.048;
        const Traced run(p);
        QCOMPARE(run.result.cycleCount, 10);
        const Pass& last = run.trajectory.passes.back();
        QVERIFY(within(last.radialFeed_mm, 0.003, 1e-16));
        for (int k = 0; k < 4; ++k) { // the ramp too is that of the shorter feed
            QVERIFY(within(run.visit(last, k).programmed_mm, 0.045 + 0.003 * (k + 1) / 4, 1e-16));
        }
    }

    // MODEL-3: h = t_П − (R_k − R_min0), R_k ← R_k + a. A rigid bore grows by the infeed.
    void boreGrowsAsTheWheelIsFed() {
        Project p = revolutions(20);
        p.part->surface = Surface::internal;
        p.wheel->diameter_mm = 20;
        setGammas(p, {1e-15});
        const Traced run(p);
        const double first = makeBlank(*p.part).firstTouchRadius_mm;
        QVERIFY(first < targetRadius(*p.part));
        for (const Pass& pass : run.trajectory.passes) {
            for (int k = 0; k < 4; ++k) {
                const Visit& v = run.visit(pass, k);
                QVERIFY(
                    within(v.radius_mm, first + v.programmed_mm, 1e-12 + 64 * fixtures::epsilon));
            }
        }
        QVERIFY(within(run.result.sections[0].radii_mm[3], targetRadius(*p.part),
                       1e-12 + 64 * fixtures::epsilon));
    }

    // MODEL-6: sections at the middles of equal slices, the gauge at ⌊J/2⌋ unless given.
    void sectionsStandInTheMiddlesOfEqualSlices() {
        Project p = revolutions(20);
        setGammas(p, {1e-5, 2e-5, 3e-5, 4e-5, 5e-5});
        const SimulationResult r = simulateUnchecked(p);
        for (std::size_t j = 0; j < 5; ++j) {
            QVERIFY(within(r.sections[j].position_mm, 40 * (double(j) + 0.5) / 5, 1e-14));
            QCOMPARE(r.sections[j].compliance_mm_per_n, (double(j) + 1) * 1e-5);
        }
    }

    void gaugeStandsInTheMiddleSectionUnlessTold_data() {
        QTest::addColumn<int>("sections");
        QTest::addColumn<int>("given"); // −1: not given
        QTest::addColumn<int>("expected");
        QTest::newRow("1 section") << 1 << -1 << 0;
        QTest::newRow("4 sections") << 4 << -1 << 2;
        QTest::newRow("5 sections") << 5 << -1 << 2;
        QTest::newRow("first") << 4 << 0 << 0;
        QTest::newRow("last") << 4 << 3 << 3;
    }
    void gaugeStandsInTheMiddleSectionUnlessTold() {
        QFETCH(int, sections);
        QFETCH(int, given);
        QFETCH(int, expected);
        Project p = fixtures::plunge();
        std::vector<double> gammas;
        for (int j = 0; j < sections; ++j) {
            gammas.push_back((1 + j) * 2e-5);
        }
        setGammas(p, gammas);
        if (given >= 0) {
            p.gauge->section = given;
        }
        const SimulationResult r = simulateUnchecked(p);
        QVERIFY(within(r.gaugeReading_mm,
                       smallestDiameter(r.sections[std::size_t(expected)].radii_mm),
                       64 * fixtures::epsilon));
    }

    // A free gauge is one more section, measured and not reported: where its γ is a section's, the
    // cycle is that section's to the last bit.
    void freeGaugeReadsItsOwnPlace_data() {
        QTest::addColumn<double>("position_mm");
        QTest::addColumn<double>("own"); // γ given with the gauge; 0: not given
        QTest::addColumn<double>("gamma");
        QTest::newRow("own compliance") << 7.0 << 4e-5 << 4e-5;
        QTest::newRow("on a section's middle") << 25.0 << 0.0 << 3e-5;
        QTest::newRow("before the first middle") << 2.0 << 0.0 << 1e-5;
        QTest::newRow("at the end") << 40.0 << 0.0 << 8e-5;
        QTest::newRow("halfway between two") << 20.0 << 0.0 << 2.5e-5;
        QTest::newRow("a quarter of the way") << 7.5 << 0.0 << 1.25e-5;
    }
    void freeGaugeReadsItsOwnPlace() {
        QFETCH(double, position_mm);
        QFETCH(double, own);
        QFETCH(double, gamma);
        Project p = fixtures::plunge();
        p.part->initial_runout_mm = 0.03;
        setGammas(p, {1e-5, 2e-5, 3e-5, 8e-5}); // middles at 5, 15, 25, 35 mm
        p.gauge->position_mm = position_mm;
        if (own > 0) {
            p.gauge->compliance_mm_per_n = own;
        }
        Project same = p; // a fifth section of that γ carries the gauge instead
        same.gauge->position_mm.reset();
        same.gauge->compliance_mm_per_n.reset();
        setGammas(same, {1e-5, 2e-5, 3e-5, 8e-5, gamma});
        same.gauge->section = 4;
        const Traced free(p);
        const SimulationResult fixed = simulateUnchecked(same);
        QCOMPARE(free.result.countsByStage, fixed.countsByStage);
        QCOMPARE(free.result.sections.size(), std::size_t(4));
        QCOMPARE(free.trajectory.passes.size(), std::size_t(4 * free.result.cycleCount));
        // Interpolation rounds γ once or twice.
        QVERIFY(within(free.result.gaugeReading_mm, fixed.gaugeReading_mm, 1e-14));
        for (std::size_t j = 0; j < 4; ++j) {
            QCOMPARE(free.result.sections[j].radii_mm, fixed.sections[j].radii_mm);
        }
        QCOMPARE(
            free.result.peakNormalForce_n,
            std::max({free.result.sections[0].peakNormalForce_n,
                      free.result.sections[1].peakNormalForce_n,
                      free.result.sections[2].peakNormalForce_n,
                      free.result.sections[3].peakNormalForce_n})); // not the gauge's own place
    }

    void plainRunAllocatesNothingPerRevolution() {
        const auto allocationsOf = [](int feeding, int sparking) {
            Project p = revolutions(feeding);
            setGammas(p, {2e-5, 3e-5, 4e-5});
            p.gauge->position_mm = 10;
            p.cycle->stages.push_back(sparkStage(fixtures::count(sparking)));
            const long long before = allocations::count;
            const SimulationResult r = simulateUnchecked(p);
            const long long used = allocations::count - before;
            return r.cycleCount == feeding + sparking ? used : -1 - r.cycleCount;
        };
        const long long used = allocationsOf(50, 50);
        QVERIFY(used > 0); // the counter counts
        QCOMPARE(allocationsOf(50, 950), used);
        QCOMPARE(allocationsOf(950, 50), used);
    }

    void sparkOutThatReachesSizeEndsWithTheReading() {
        Project p = revolutions(20);
        p.part->stock_mm = 0.1;
        // 0.5 µm a revolution leaves a deflection of 1.3 µm, of which the spark-out takes up to 1
        p.cycle->stages = {plungeStage(0.09, 0.099), sparkStage(fixtures::untilSize(), 0.001)};
        p.gauge->control = Control::gauge;
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.status, RunStatus::completed);
        QVERIFY(r.countsByStage[1] >= 2);
        QVERIFY(r.remainingStock_mm <= 1e-9);
    }

    // MODEL-7: a hundred revolutions without removal above 1e-9 mm, nothing more to come.
    void sparkOutThatStallsEndsAfterAHundredIdleRevolutions() {
        Project p = revolutions(20);
        p.wheel->dullness = 0; // removal dies away like r^m, not like 1/m²
        p.part->stock_mm += 0.004;
        p.cycle->stages.push_back(sparkStage(fixtures::untilSize(), 0.004));
        const Traced run(p);
        const SimulationResult& r = run.result;
        QCOMPARE(r.status, RunStatus::cannotReachSize);
        std::vector<double> most;
        for (const Pass& pass : run.trajectory.passes) {
            most.push_back(0);
            for (int k = 0; k < 4; ++k) {
                most.back() = std::max(most.back(), run.visit(pass, k).actual_mm);
            }
        }
        const auto idle =
            std::find_if(most.rbegin(), most.rend(), [](double a) { return a > 1e-9; });
        QCOMPARE(idle - most.rbegin(), 100);
        // The size reached: all that was fed is cut, the deflection of a nanometre's removal and
        // less has had 100 revolutions to go.
        QVERIFY(within(r.remainingStock_mm, 0.004, 1e-12));
        QVERIFY(within(r.gaugeReading_mm / 2, targetRadius(*p.part) + r.remainingStock_mm,
                       64 * fixtures::epsilon));
        QCOMPARE(r.countsByStage[0], 20);
        QCOMPARE(r.cycleCount, int(most.size()));
    }

    // A dull wheel's spark-out goes on like 1/n² and still ends.
    void dullWheelsStallEndsToo() {
        Project p = revolutions(20);
        p.part->stock_mm += 0.004;
        p.cycle->stages.push_back(sparkStage(fixtures::untilSize(), 0.004));
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.status, RunStatus::cannotReachSize);
        // depth ≈ (γK4)²/n² = 1e-9 mm at n = γK4/√1e-9 = 1803, and a hundred more. The next term
        // of 1/√depth is (2A − 1)·ln n ≈ 8 and constants, for 1 % each side.
        const double limit = 2e-5 * 40 * fixtures::Law(p).kr;
        QVERIFY(within(r.countsByStage[1], limit / std::sqrt(1e-9) + 100, 18));
    }

    void stopRequestedBeforehandEndsBeforeTheFirstRevolution() {
        const StoppedSource source;
        const SimulationResult r =
            simulateUnchecked(fixtures::plunge(), nullptr, source.get_token());
        QCOMPARE(r.status, RunStatus::stopped);
        QCOMPARE(r.cycleCount, 0);
        QCOMPARE(r.time_s, 0.0);
    }

    void runWithTooManyVisitsEnds() {
        Project p = revolutions(1);
        p.part->radii_per_section = 360;
        setGammas(p, std::vector<double>(20, 2e-5));
        p.cycle->stages.push_back(sparkStage(fixtures::count(100'000)));
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.status, RunStatus::tooLong);
        QVERIFY(r.visits > maxVisits - 7200 && r.visits <= maxVisits + 7200);
        QCOMPARE(r.visits, 7200LL * r.cycleCount);
    }
};

} // namespace sparkout::test_plunge_cycle

SPARKOUT_TEST(test_plunge_cycle, TestPlungeCycle)
#include "test_plunge_cycle.moc"
