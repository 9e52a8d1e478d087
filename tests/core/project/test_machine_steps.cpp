// SPDX-License-Identifier: GPL-3.0-or-later
// The values that the controls of a machine take.

#include "core/project/machine.h"
#include "core/project/project.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>

namespace sparkout::test_machine_steps {

class TestMachineSteps : public QObject {
    Q_OBJECT

private slots:
    void aValueGoesToTheNextOneOfTheMachineAndNotBeyondItsEnds() {
        const MachineSteps steps{0.0005, 0.0203, 0.0005};
        const auto is = [&steps](double value, int by, double wanted) {
            return std::abs(steps.stepped(value, by) - wanted) < 1e-12;
        };
        QVERIFY(is(0.004, 1, 0.0045) && is(0.004, -1, 0.0035) && is(0.004, 3, 0.0055));
        QVERIFY(is(0.0042, 1, 0.0045) && is(0.0042, -1, 0.004));
        QVERIFY(is(0.0005, -1, 0.0005) && is(0.02, 1, 0.02)); // 0.0205 is too much
        QVERIFY(is(0, 1, 0.0005) && is(0, -1, 0));
        QVERIFY(is(0.05, -1, 0.02) && is(0.05, 1, 0.05));
        QVERIFY(is(-0.004, 1, -0.0035) && is(-0.004, -1, -0.0045));
        for (int k = 1; k < 40; ++k) { // no last bits
            QCOMPARE(steps.stepped(k * 0.0005, 1), (k + 1) * 5 / 1e4);
        }
    }

    void everySettingHasTheRangeOfItsControl() {
        Project project = samples::project("stiffness-traverse");
        MachineLimits& limits = project.machine->limits;
        limits = {};
        for (const char* path :
             {"/machine/work_speed_rpm", "/machine/plunge_feed_mm_min",
              "/cycle/stages/0/radial_feed_mm", "/cycle/stages/1/axial_feed_mm_min",
              "/cycle/stages/0/continuous_feed_mm_min", "/cycle/stages/0/stock_mm"}) {
            QVERIFY2(!machineRange(project, path) && !machineSteps(project, path), path);
        }
        limits.radial_feed_mm = {{0.0005, 0.02, 0.0005}};
        limits.axial_feed_mm_min = {{20, 5000, 50}};
        limits.plunge_feed_mm_min = {{0.02, 5, 0.01}};
        limits.continuous_feed_mm_min = {{0, 0, 0}}; // a machine without it
        limits.work_speed_rpm = {{60, 600, 10}};
        const auto step = [&project](const char* path) {
            const auto steps = machineSteps(project, path);
            return steps ? steps->step : 0;
        };
        QCOMPARE(step("/machine/work_speed_rpm"), 10.0);
        QCOMPARE(step("/machine/plunge_feed_mm_min"), 0.01);
        QCOMPARE(step("/cycle/stages/0/radial_feed_mm"), 0.0005);
        QCOMPARE(step("/cycle/stages/12/axial_feed_mm_min"), 50.0);
        QCOMPARE(step("/cycle/stages/0/continuous_feed_mm_min"), 0.0);
        QVERIFY(machineRange(project, "/cycle/stages/0/continuous_feed_mm_min"));
        QCOMPARE(step("/cycle/stages/0/stock_mm"), 0.0005);
        QCOMPARE(step("/part/stock_mm"), 0.0);                     // of the blank
        QCOMPARE(step("/cycle/stages/0/radial_feed_mm_min"), 0.0); // it is not plunged
        project.operation = Operation::plunge;
        QCOMPARE(step("/cycle/stages/0/radial_feed_mm_min"), 0.01);
    }
};

} // namespace sparkout::test_machine_steps

SPARKOUT_TEST(test_machine_steps, TestMachineSteps)
#include "test_machine_steps.moc"
