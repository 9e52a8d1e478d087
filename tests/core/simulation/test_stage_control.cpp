// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/stage_control.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_stage_control {

using fixtures::within;

constexpr double total = 0.25; ///< |R_first − R_t| [mm]

/// Stages that remove these stocks [mm]; each feeds 5 µm a step.
Project cycle(const std::vector<double>& stocks, Control control = Control::gauge) {
    Project p = fixtures::plunge();
    p.gauge->control = control;
    p.cycle->stages.clear();
    for (const double stock : stocks) {
        p.cycle->stages.push_back(fixtures::plungeStage(0.9, stock));
    }
    return p;
}

StageControl controlOf(const Project& p) {
    return {p, std::vector<double>(p.cycle->stages.size(), 0.005), total};
}

using Counts = std::vector<int>;

class TestStageControl : public QObject {
    Q_OBJECT

private slots:
    void stageEndsAtTheStocksOfTheLaterOnes() {
        StageControl control = controlOf(cycle({0.1, 0.06, 0.04}));
        const double thresholds[] = {0.1, 0.04, 0};
        for (std::size_t z = 0; z < 3; ++z) {
            QCOMPARE(control.stage(), z);
            QVERIFY(!control.finished());
            control.stepDone(thresholds[z] + 1e-6, 0, 0);
            QCOMPARE(control.stage(), z);
            control.stepDone(thresholds[z], 0, 0);
            QCOMPARE(control.stage(), z + 1);
        }
        QVERIFY(control.finished());
        QCOMPARE(control.stepsByStage(), (Counts{2, 2, 2}));
    }

    // MODEL-7: Π_rem ≤ Σ Π_j + 1e-9 mm
    void thresholdCarriesANanometreOfAThousandth() {
        StageControl early = controlOf(cycle({0.1, 0.04}));
        early.stepDone(0.04 + 0.999e-9, 0, 0);
        QCOMPARE(early.stage(), std::size_t(1));
        StageControl late = controlOf(cycle({0.1, 0.04}));
        late.stepDone(0.04 + 1.001e-9, 0, 0);
        QCOMPARE(late.stage(), std::size_t(0));
    }

    void severalStagesMayEndAtOneReading() {
        StageControl two = controlOf(cycle({0.1, 0.06, 0.04}));
        two.stepDone(0.03, 0, 0);
        QCOMPARE(two.stage(), std::size_t(2));
        QCOMPARE(two.stepsByStage(), (Counts{1, 0, 0}));
        StageControl all = controlOf(cycle({0.1, 0.06, 0.04}));
        all.stepDone(-0.001, 0, 0);
        QVERIFY(all.finished());
        QCOMPARE(all.stepsByStage(), (Counts{1, 0, 0}));
    }

    void onlyTheLaterStagesStocksMatter() {
        StageControl a = controlOf(cycle({0.1, 0.04}));
        StageControl b = controlOf(cycle({77, 0.04}));
        for (const double reading : {0.2, 0.05, 0.039, 0.001, 0.0}) {
            a.stepDone(reading, 0, 0);
            b.stepDone(reading, 0, 0);
            QCOMPARE(a.stage(), b.stage());
        }
        QVERIFY(a.finished());
    }

    void sparkOutByCountRunsItsCountWhateverIsRead() {
        Project p = cycle({0.1, 0.0});
        p.cycle->stages[1].spark_out = fixtures::count(3);
        StageControl control = controlOf(p);
        QCOMPARE(control.nextInfeed(0), 0.005);
        control.stepDone(-0.5, 0.1, 0); // past every threshold: the count is still run
        QCOMPARE(control.stage(), std::size_t(1));
        for (int i = 0; i < 3; ++i) {
            QVERIFY(!control.finished());
            QVERIFY(!control.waitsForSize());
            QCOMPARE(control.nextInfeed(0.1), 0.0);
            control.stepDone(i == 1 ? 0.2 : -0.5, 0.1, 0);
        }
        QVERIFY(control.finished());
        QCOMPARE(control.stepsByStage(), (Counts{1, 3}));
    }

    void sparkOutUntilSizeFeedsNothingAndWaitsForTheReading_data() {
        QTest::addColumn<Control>("end");
        QTest::newRow("gauge") << Control::gauge;
        QTest::newRow("position") << Control::position;
    }
    void sparkOutUntilSizeFeedsNothingAndWaitsForTheReading() {
        QFETCH(Control, end);
        Project p = cycle({0.1, 0.01}, end);
        p.cycle->stages[1].spark_out = fixtures::untilSize();
        StageControl control = controlOf(p);
        QVERIFY(!control.waitsForSize());
        control.stepDone(0.005, total - 0.01, 0);
        QCOMPARE(control.stage(), std::size_t(1));
        QVERIFY(control.waitsForSize());
        QCOMPARE(control.nextInfeed(0), 0.0);
        control.stepDone(1e-6, total, 0); // t_П has no say here
        QVERIFY(!control.finished());
        control.stepDone(0, 0, 0);
        QVERIFY(control.finished());
    }

    void positionControlFeedsToTheStagesEndAndCutsItsLastStepShort() {
        StageControl control = controlOf(cycle({0.21, 0.04}, Control::position));
        QCOMPARE(control.nextInfeed(0), 0.005);
        QCOMPARE(control.nextInfeed(0.2), 0.005);
        QVERIFY(within(control.nextInfeed(0.208), 0.002, 4e-17)); // 0.25 − 0.04 − 0.208
        QCOMPARE(control.nextInfeed(0.22), 0.0);                  // never back
        control.stepDone(-1, 0.2, 0);                             // the reading has no say
        QCOMPARE(control.stage(), std::size_t(0));
        control.stepDone(1, 0.21, 0);
        QCOMPARE(control.stage(), std::size_t(1));
        QCOMPARE(control.nextInfeed(0.21), 0.005);
        QVERIFY(within(control.nextInfeed(0.249), 0.001, 4e-17));
        control.stepDone(1, 0.25, 0);
        QVERIFY(control.finished());
    }

    void positionControlsThresholdCarriesTheSameSlack() {
        StageControl early = controlOf(cycle({0.21, 0.04}, Control::position));
        early.stepDone(1, 0.21 - 0.999e-9, 0);
        QCOMPARE(early.stage(), std::size_t(1));
        StageControl late = controlOf(cycle({0.21, 0.04}, Control::position));
        late.stepDone(1, 0.21 - 1.001e-9, 0);
        QCOMPARE(late.stage(), std::size_t(0));
    }

    void laterStocksBeyondTheWholeEndAPositionStageAfterOneEmptyStep() {
        StageControl control = controlOf(cycle({0.1, 0.3, 0.1}, Control::position));
        QCOMPARE(control.nextInfeed(0), 0.0);
        control.stepDone(0.25, 0, 0);
        QCOMPARE(control.stage(), std::size_t(1));
        QCOMPARE(control.stepsByStage(), (Counts{1, 0, 0}));
        QCOMPARE(control.nextInfeed(0), 0.005);
    }

    void gaugeControlFeedsTheStagesOwnInfeed() {
        const Project p = cycle({0.1, 0.04});
        StageControl control(p, {0.005, 0.002}, total);
        QCOMPARE(control.nextInfeed(0.2499), 0.005); // it does not look at t_П
        control.stepDone(0.04, 0, 0);
        QCOMPARE(control.nextInfeed(0.2499), 0.002);
    }

    // Six radii: diameters pair k with k + 3. Depths 1, 2, 3 and 5, 4, 9 µm: sums 6, 6, 12.
    void gaugeReadsDiametersByItsRule_data() {
        addColumns<GaugeRule, double>("rule", "depth_um");
        QTest::newRow("min: the deepest") << GaugeRule::min << 6.0;
        QTest::newRow("mean") << GaugeRule::mean << 4.0;
        QTest::newRow("max: the shallowest") << GaugeRule::max << 3.0;
    }
    void gaugeReadsDiametersByItsRule() {
        QFETCH(GaugeRule, rule);
        QFETCH(double, depth_um);
        const double depths[] = {0.001, 0.002, 0.003, 0.005, 0.004, 0.009};
        QVERIFY(within(remainingStock(depths, 6, rule, total), total - depth_um / 1000, 1e-16));
    }

    // MODEL-4: in a bore min and max change places, so that both surfaces go by the deepest cut.
    void rulesAreMirroredInABore_data() {
        QTest::addColumn<GaugeRule>("rule");
        QTest::newRow("min") << GaugeRule::min;
        QTest::newRow("mean") << GaugeRule::mean;
        QTest::newRow("max") << GaugeRule::max;
    }
    void rulesAreMirroredInABore() {
        QFETCH(GaugeRule, rule);
        for (const Surface surface : {Surface::external, Surface::internal}) {
            Project p = fixtures::plunge();
            p.part->surface = surface;
            p.part->initial_runout_mm = 0.03;
            p.part->stock_mm = 0.05;
            p.cycle->stages[0].stock_mm = 0.05;
            p.wheel->diameter_mm = 20;
            p.gauge->rule = rule;
            const SimulationResult r = simulateUnchecked(p);
            const auto& R = r.sections[0].radii_mm;
            const double a = R[0] + R[2], b = R[1] + R[3];
            const bool smallest = (rule == GaugeRule::min) == (surface == Surface::external);
            const double reading = rule == GaugeRule::mean ? (a + b) / 2
                                   : smallest              ? std::min(a, b)
                                                           : std::max(a, b);
            QVERIFY(std::abs(a - b) > 1e-5); // the rules must differ for the test to mean anything
            QVERIFY(within(r.gaugeReading_mm, reading, 64 * fixtures::epsilon));
        }
    }
};

} // namespace sparkout::test_stage_control

SPARKOUT_TEST(test_stage_control, TestStageControl)
#include "test_stage_control.moc"
