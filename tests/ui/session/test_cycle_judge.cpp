// SPDX-License-Identifier: GPL-3.0-or-later
// How the cycle in front stands: its stocks with the run or after it, its batch a little later.
#include "core/measured/adequacy.h"
#include "core/project/measured.h"
#include "core/study/batch_edits.h"
#include "core/study/new_project.h"
#include "tests/registry.h"
#include "tests/two_stage_projects.h"
#include "ui/session/run_controller.h"

#include <QSignalSpy>
#include <QTest>

namespace sparkout::test_cycle_judge {

/// The judge behind real runs, as the window has it.
struct Bench {
    Bench() {
        QObject::connect(&runs, &RunController::finished, &runs,
                         [this](const OutcomePtr& outcome) { judge.setOutcome(outcome); });
    }
    void run(const Project& project) {
        QSignalSpy finished(&runs, &RunController::finished);
        runs.request(project);
        QTRY_COMPARE(finished.size(), 1);
    }

    Studies studies;
    RunController runs;
    CycleJudge judge{runs, studies};
};

constexpr int patience_ms = 60'000;

class TestCycleJudge : public QObject {
    Q_OBJECT

private slots:
    void stocksComeWithTheRunOrAfterIt() {
        Bench bench;
        bench.run(fixtures::plungeProject(3));
        QTRY_VERIFY(!bench.judge.judged().areStocksComing);
        const JudgedRun& judged = bench.judge.judged();
        const Outcome& outcome = *judged.outcome;
        const std::optional<JudgedStocks> wanted = judgeStocks(outcome.result);
        QVERIFY(wanted && judged.judgement.stocks);
        QCOMPARE(judged.judgement.stocks->holds, wanted->holds);
        QCOMPARE(judged.judgement.stocks->failingShare, wanted->failingShare);
        QCOMPARE(judged.judgement.state, judge(outcome.result, outcome.constraints, wanted).state);
        QVERIFY(!judged.hasBatch);
        QVERIFY(!judged.isBatchComing);
    }

    void quickBatchIsRunByItself() {
        Bench bench;
        QSignalSpy changed(&bench.judge, &CycleJudge::changed);
        const Project project = withUsualBatch(fixtures::plungeProject(3));
        bench.run(project);
        QVERIFY(bench.judge.judged().hasBatch);
        QVERIFY(bench.judge.judged().isBatchComing);
        QVERIFY(!bench.judge.judged().judgement.batch);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.judge.judged().isBatchComing, patience_ms);
        QVERIFY(!changed.empty());
        const JudgedBatch& batch = *bench.judge.judged().judgement.batch;
        QCOMPARE(batch.parts, std::int64_t{project.batch->parts});
        QVERIFY(batch.isWhole);
        const BatchResult wanted = runBatch(project);
        QCOMPARE(batch.bad, wanted.statistics.bad);
    }

    /// One that takes longer is left to its view; until then the cycle is not plainly fit.
    void slowBatchKeepsTheCycleFromPlainGreen() {
        Bench bench;
        Project project = fixtures::plungeProject(3);
        project.part->tolerance.radial_runout_um.reset();
        project.part->upper_deviation_um = 900;
        project.part->lower_deviation_um = -900;
        project = withUsualBatch(project);
        project.batch->parts = 1'000'000;
        bench.run(project);
        QTRY_VERIFY(!bench.judge.judged().areStocksComing);
        const JudgedRun& judged = bench.judge.judged();
        QVERIFY(judged.hasBatch && !judged.isBatchComing && !isBatchQuick(judged.outcome->result));
        QVERIFY(judged.judgement.stocks && judged.judgement.stocks->holds);
        QCOMPARE(judged.judgement.state, JudgedState::batchNotRun);
    }

    /// An edit drops what was known of the inputs before.
    void batchOfOtherInputsIsNotTold() {
        Bench bench;
        Project project = withUsualBatch(fixtures::plungeProject(3));
        bench.run(project);
        QTRY_VERIFY_WITH_TIMEOUT(bench.judge.judged().judgement.batch.has_value(), patience_ms);
        project.part->stock_mm += 0.001;
        project.cycle->stages.front().stock_mm += 0.001;
        bench.run(project);
        QVERIFY(!bench.judge.judged().judgement.batch);
        QVERIFY(bench.judge.judged().isBatchComing);
    }

    void batchOfTheViewIsTaken() {
        Bench bench;
        const Project project = withUsualBatch(fixtures::plungeProject(3));
        bench.studies.runBatch(project);
        QTRY_VERIFY_WITH_TIMEOUT(bench.studies.batch.isOf(project), patience_ms);
        bench.run(project);
        QVERIFY(bench.judge.judged().judgement.batch.has_value());
        QVERIFY(!bench.judge.judged().isBatchComing);
        QVERIFY(!bench.studies.judged.result());
    }

    /// Once the batch that predicts them has been run.
    void measuredPartsThatDifferAreTold() {
        Bench bench;
        Project project = withUsualBatch(fixtures::plungeProject(3));
        project.batch->parts = 5;
        MeasuredSummary summary;
        summary.place = 2;
        summary.count = 30;
        summary.mean_um = 500;
        summary.deviation_um = 1;
        project.measured.emplace().summaries = {summary};
        bench.run(project);
        const JudgedRun& judged = bench.judge.judged();
        QVERIFY(!judged.judgement.measured);
        bench.studies.runPrediction(predictingProject(project));
        QTRY_VERIFY_WITH_TIMEOUT(judged.judgement.measured.has_value(), patience_ms);
        QCOMPARE(judged.judgement.measured->section, 2);
        QVERIFY(judged.judgement.measured->bias_um > 400);
        project.cycle->stages.back().radial_feed_mm_min = 0.1; // other inputs, not predicted yet
        bench.run(project);
        QVERIFY(!judged.judgement.measured);
    }

    void batchIsNotToldWhereItMayNot() {
        Bench bench;
        bench.judge.judgeBatches(false);
        bench.run(withUsualBatch(fixtures::plungeProject(3)));
        QVERIFY(!bench.judge.judged().hasBatch);
        QVERIFY(!bench.judge.judged().isBatchComing);
        bench.judge.judgeBatches(true);
        QVERIFY(bench.judge.judged().hasBatch);
        QTRY_VERIFY_WITH_TIMEOUT(bench.judge.judged().judgement.batch.has_value(), patience_ms);
        bench.judge.judgeBatches(false);
        QVERIFY(!bench.judge.judged().judgement.batch);
    }

    void refusedInputsAreNotComputed() {
        Bench bench;
        Project project = fixtures::plungeProject(3);
        project.wheel->width_mm = -1;
        bench.run(project);
        QCOMPARE(bench.judge.judged().judgement.state, JudgedState::notComputed);
    }
};

} // namespace sparkout::test_cycle_judge

SPARKOUT_TEST(test_cycle_judge, TestCycleJudge)
#include "test_cycle_judge.moc"
