// SPDX-License-Identifier: GPL-3.0-or-later
// What only a run shows to be amiss in the inputs.
#include "core/quality/roughness.h"
#include "core/quality/verdict.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_remarks {

Project example(const char* name) {
    const ReadResult read = readProject(
        samples::readText(samples::sourcePath(std::string("resources/examples/") + name)));
    return *read.project;
}

double millimetres(const Detail& detail) {
    const auto& amount = std::get<Amount>(detail);
    return amount.unit == "mm" ? amount.number : std::numeric_limits<double>::quiet_NaN();
}

class TestRemarks : public QObject {
    Q_OBJECT

private slots:
    // Stage z ends when the later ones' stock is left: a last stage that feeds nothing takes of it
    // only what the deflection gives back.
    void aCountedSparkOutThatLeavesItsStockIsNamedWithStageAndStock_data() {
        QTest::addColumn<bool>("internal");
        QTest::newRow("external") << false;
        QTest::newRow("internal") << true;
    }
    void aCountedSparkOutThatLeavesItsStockIsNamedWithStageAndStock() {
        QFETCH(bool, internal);
        Project project = example(internal ? "internal-plunge.sparkout" : "wheel-sharp.sparkout");
        auto& stages = project.cycle->stages;
        QCOMPARE(stages.back().spark_out.mode, SparkOut::Mode::count);
        QVERIFY(
            remarksOn(simulateUnchecked(project)).empty()); // the deflection gives back what it has
        stages[0].stock_mm -= 0.04;
        stages.back().stock_mm += 0.04;
        const SimulationResult result = simulateUnchecked(project);
        QCOMPARE(result.status, RunStatus::completed);
        QVERIFY(result.remainingStock_mm > 0.02);
        const Issues remarks = remarksOn(result);
        QCOMPARE(remarks.size(), 1u);
        QCOMPARE(remarks[0].code, IssueCode::sparkOutLeaves);
        QCOMPARE(remarks[0].severity, Severity::warning);
        QCOMPARE(remarks[0].path,
                 "/cycle/stages/" + std::to_string(stages.size() - 1) + "/stock_mm");
        QVERIFY(std::abs(millimetres(remarks[0].value) - result.remainingStock_mm) < 1e-5);
        QVERIFY(std::abs(millimetres(remarks[0].limit) - stages.back().stock_mm) < 1e-5);
    }

    // Beside a measured Ra another factor is named with what that one gives.
    void factorFarFromTheMeasuredRaIsNamed() {
        Project project = example("wheel-sharp.sparkout");
        project.wheel->measured_ra = MeasuredRa{0.5, {}, {}};
        const SimulationResult followed = simulateUnchecked(project);
        QVERIFY(remarksOn(followed).empty());
        const double factor = roughnessFactor(project).least;
        project.wheel->roughness_factor = 1.5 * factor; // as another speed may have it
        QVERIFY(remarksOn(simulateUnchecked(project)).empty());
        project.wheel->roughness_factor = 2 * factor;
        const Issues remarks = remarksOn(simulateUnchecked(project));
        QCOMPARE(remarks.size(), 1u);
        QCOMPARE(remarks[0].code, IssueCode::unusualTogether);
        QCOMPARE(remarks[0].severity, Severity::warning);
        QCOMPARE(remarks[0].path, std::string("/wheel/roughness_factor"));
        QCOMPARE(std::get<Amount>(remarks[0].value).number, 2 * factor);
        const auto& allowed = std::get<Bounds>(remarks[0].limit);
        QVERIFY(allowed.range.contains(factor) && !allowed.range.contains(2 * factor));
        QCOMPARE(allowed.field, std::string_view("/wheel/measured_ra/ra_um"));
    }

    // No factor within its range gives that Ra: it is not used, the project stays one that can be
    // saved, and the remark states the greatest Ra that could be.
    void measuredRaBeyondEveryFactorIsNamed() {
        Project project = example("wheel-sharp.sparkout");
        project.wheel->measured_ra = MeasuredRa{50, 1e-3, {}};
        QVERIFY(!factorOfMeasuredRa(project));
        const Project with = withMeasuredRa(project);
        QCOMPARE(with.wheel->roughness_factor, 1.0);
        const Issues remarks = remarksOn(simulateUnchecked(project));
        QCOMPARE(remarks.size(), 1u);
        QCOMPARE(remarks[0].path, std::string("/wheel/measured_ra/ra_um"));
        const auto& allowed = std::get<Bounds>(remarks[0].limit);
        QVERIFY(!allowed.range.contains(50));
        project.wheel->measured_ra->ra_um = 0.999 * allowed.range.high;
        QVERIFY(factorOfMeasuredRa(project).value() > 0.99 * mostRoughnessFactor);
    }

    void withoutStockNothingIsLeft() {
        Project project = example("wheel-sharp.sparkout");
        auto& stages = project.cycle->stages;
        stages[0].stock_mm += stages.back().stock_mm;
        stages.back().stock_mm = 0;
        QVERIFY(remarksOn(simulateUnchecked(project)).empty());
    }

    void untilSizeEndsAtSizeOrSaysSoItself() {
        Project project = example("wheel-sharp.sparkout");
        project.cycle->stages.back().spark_out = {SparkOut::Mode::untilSize, 0};
        QVERIFY(remarksOn(simulateUnchecked(project)).empty());
        project.cycle->stages[0].stock_mm -= 0.04;
        project.cycle->stages.back().stock_mm += 0.04;
        const SimulationResult result = simulateUnchecked(project);
        QCOMPARE(result.status, RunStatus::cannotReachSize);
        QVERIFY(remarksOn(result).empty());
    }

    // A first stage that feeds far beyond the stock of the second leaves it nothing.
    void aStageWhoseStockIsGoneBeforeItBeginsIsNamed() {
        Project project = example("shaft-30h6-factory.sparkout");
        auto& stages = project.cycle->stages;
        stages[0].radial_feed_mm = 0.04;
        stages[0].stock_mm += 0.035;
        stages[1].stock_mm -= 0.035;
        const SimulationResult result = simulateUnchecked(project);
        QCOMPARE(result.countsByStage[1], 0);
        const Issues remarks = remarksOn(result);
        QCOMPARE(remarks.size(), 1u);
        QCOMPARE(remarks[0].code, IssueCode::stageIdle);
        QCOMPARE(remarks[0].path, std::string("/cycle/stages/1/stock_mm"));
        QCOMPARE(remarks[0].value, Detail(Count{2}));
    }

    // 0.05 s at 180 revolutions a minute are 0.15 revolutions, made as one: 1/3 s.
    void aDwellThatBecomesAnotherIsNamedAsItIsMade() {
        Project project = example("shaft-30h6-factory.sparkout");
        QVERIFY(project.machine->work_speed_rpm == 180);
        project.machine->dwell_entry_s = 0.05;
        const Issues remarks = remarksOn(simulateUnchecked(project));
        QCOMPARE(remarks.size(), 1u);
        QCOMPARE(remarks[0].code, IssueCode::dwellRounded);
        QCOMPARE(remarks[0].path, std::string("/machine/dwell_entry_s"));
        QCOMPARE(remarks[0].value, Detail(Amount{0.05, "s"}));
        QCOMPARE(remarks[0].limit, Detail(Amount{0.333, "s"}));
    }

    void theExamplesHaveNoneToMake() {
        for (const char* name : {"internal-plunge", "plunge-shaft-two-stage", "shaft-30h6-factory",
                                 "spark-out-until-size", "wheel-dull", "wheel-sharp"}) {
            const std::string file = std::string(name) + ".sparkout";
            QVERIFY2(remarksOn(simulateUnchecked(example(file.c_str()))).empty(), name);
        }
    }
};

} // namespace sparkout::test_remarks

SPARKOUT_TEST(test_remarks, TestRemarks)
#include "test_remarks.moc"
