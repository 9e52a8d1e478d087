// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of a batch: what the script of a cluster asks for holds the largest batch there is.
#include "core/batch/batch_memory.h"
#include "core/batch/characteristics.h"
#include "core/project/batch.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <QRegularExpression>
#include <QTest>

namespace test_batch_memory {

using namespace sparkout;

namespace {

constexpr std::size_t mebi = std::size_t{1} << 20;

/// As many sections and parts as a project may have, everything required of each.
Project largest() {
    Project project = fixtures::stiffBatch(1'000'000);
    project.machine->compliance_mm_per_n = std::vector<double>{1e-6};
    project.sections = static_cast<int>(tableOf<Project>().find("sections")->hard.high);
    Tolerance& tolerance = project.part->tolerance;
    tolerance.roundness_um = tolerance.cylindricity_um = tolerance.total_runout_um = 50;
    tolerance.radial_runout_um = tolerance.roughness_ra_um = 50;
    project.machine->work_drive_kw = 2;
    Factors& factors = project.batch->factors;
    factors.stock_mm = fixtures::uniform(0.13, 0.17);
    factors.initial_runout_mm = fixtures::uniform(0.01, 0.03);
    factors.dullness = fixtures::uniform(0.015, 0.03);
    factors.wheel_diameter_mm = fixtures::uniform(500, 600);
    factors.flow_stress_mpa = fixtures::uniform(1000, 1200);
    factors.compliance = fixtures::uniform(0.9, 1.1);
    return project;
}

/// A number that a directive of the script gives.
std::size_t asked(const char* pattern) {
    const QString script = QString::fromStdString(
        samples::readText(samples::sourcePath("resources/help/batch.sbatch")));
    const auto found =
        QRegularExpression(QLatin1String(pattern), QRegularExpression::MultilineOption)
            .match(script);
    return found.captured(1).toULongLong();
}

} // namespace

class TestBatchMemory : public QObject {
    Q_OBJECT

private slots:
    void theScriptAsksForWhatTheLargestBatchNeeds() {
        const Project project = largest();
        QCOMPARE(project.sections, 200);
        QCOMPARE(characteristicsOf(project).size(), std::size_t{200 * 6 + 5});
        const std::size_t memory = asked("^#SBATCH --mem=(\\d+)G$") * 1024 * mebi;
        const std::size_t threads = asked("^#SBATCH --cpus-per-task=(\\d+)$");
        QVERIFY(memory > 0 && threads > 0);
        const std::size_t batch = batchMemory(project, static_cast<int>(threads));
        const std::size_t merge = mergeMemory(project);
        qInfo("largest batch %zu MiB with %zu threads, merge %zu MiB, asked for %zu MiB",
              batch / mebi, threads, merge / mebi, memory / mebi);
        QVERIFY(batch <= memory / 10 * 9); // upper bounds, and a tenth to spare
        QVERIFY(merge <= memory / 10 * 9);
    }

    void theEstimateKnowsWhatItGrowsWith() {
        Project project = largest();
        QVERIFY(batchMemory(project, 9) > batchMemory(project, 8));
        const std::size_t many = batchMemory(project, 8);
        project.batch->parts = 5000; // beyond the kept rows and the bins nothing grows
        QCOMPARE(batchMemory(project, 8), many);
        project.batch->parts = 50;
        QVERIFY(batchMemory(project, 8) < many / 2);
        project.sections = 4;
        QVERIFY(batchMemory(project, 8) < many / 10);
    }
};

} // namespace test_batch_memory

SPARKOUT_TEST(test_batch_memory, TestBatchMemory)
#include "test_batch_memory.moc"
