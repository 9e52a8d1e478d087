// SPDX-License-Identifier: GPL-3.0-or-later
// Traces beside the simulated cycle: aligned in time, with their residuals; and which parameters
// such data can tell.

#include "core/measured/fit_data.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/ui/support/traced_project.h"

namespace sparkout::test_trace_comparison {

std::vector<int> stepsOf(const Project& project) {
    return simulate(project).countsByStage;
}

class TestTraceComparison : public QObject {
    Q_OBJECT

private slots:
    void aTraceOfTheProjectsOwnCycleLeavesItsNoise() {
        Project project = traced::project(true, 3.5);
        const Project truth = traced::truth();
        project.machine->compliance_mm_per_n = truth.machine->compliance_mm_per_n;
        project.wheel->dullness = truth.wheel->dullness;
        const auto found = compareTraces(project, stepsOf(project));
        QCOMPARE(found.size(), std::size_t{2});
        const TraceComparison &size = found[0], &power = found[1];
        QCOMPARE(size.source, FitSource::size);
        QCOMPARE(power.source, FitSource::power);
        QVERIFY2(std::abs(size.shift_s - 3.5) < 0.05, qPrintable(QString::number(size.shift_s)));
        QCOMPARE(size.shift_s, power.shift_s); // one file has one clock
        QVERIFY2(std::abs(size.offset_mm - 0.02) < 1e-4,
                 qPrintable(QString::number(size.offset_mm)));
        QVERIFY2(size.rms > 0.0003 && size.rms < 0.0007, qPrintable(QString::number(size.rms)));
        QVERIFY2(power.rms > 0.006 && power.rms < 0.02, qPrintable(QString::number(power.rms)));
        QCOMPARE(size.time_s.size(), project.measured->traces[0].values.size());
        QVERIFY(std::abs(size.time_s.front() + size.shift_s) < 1e-12);
        for (std::size_t i = 0; i < size.time_s.size(); ++i) {
            QVERIFY(std::abs(size.measured[i] - size.predicted[i]) < 0.005);
        }
    }

    void anUncalibratedProjectLeavesMore() {
        const Project project = traced::project(true);
        const auto found = compareTraces(project, stepsOf(project));
        QCOMPARE(found.size(), std::size_t{2});
        QVERIFY2(found[0].rms > 0.002, qPrintable(QString::number(found[0].rms)));
    }

    void withoutTracesThereIsNothing() {
        QVERIFY(compareTraces(traced::plunge(), stepsOf(traced::plunge())).empty());
        Project stopped = traced::project();
        const StoppedSource stop;
        QVERIFY(compareTraces(stopped, stepsOf(stopped), stop.get_token()).empty());
    }

    void whatDataCanTellIsProposed() {
        const auto proposed = [](const Project& project) {
            return proposedParameters(fitDataOf(project, {}, true));
        };
        const std::vector<FittedKind> size{FittedKind::alpha, FittedKind::beta,
                                           FittedKind::size_offset, FittedKind::time_shift};
        QVERIFY(proposed(traced::project()) == size);
        const std::vector<FittedKind> power{FittedKind::alpha,       FittedKind::beta,
                                            FittedKind::chip_power,  FittedKind::friction_power,
                                            FittedKind::size_offset, FittedKind::time_shift};
        QVERIFY(proposed(traced::project(true)) == power); // its idle power is stated
        Project force = traced::project();
        force.measured->traces.push_back(force.measured->traces.front());
        force.measured->traces.back().quantity = TraceQuantity::normal_force;
        const std::vector<FittedKind> apart = proposed(force);
        for (const FittedKind kind :
             {FittedKind::compliance, FittedKind::flow_stress, FittedKind::dullness}) {
            QVERIFY(std::ranges::find(apart, kind) != apart.end());
        }
        QVERIFY(std::ranges::find(apart, FittedKind::alpha) == apart.end());
        QVERIFY(proposed(traced::plunge()).empty());
    }
};

} // namespace sparkout::test_trace_comparison

SPARKOUT_TEST(test_trace_comparison, TestTraceComparison)
#include "test_trace_comparison.moc"
