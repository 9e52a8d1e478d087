// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_state.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/study/batch_edits.h"
#include "core/study/new_project.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "ui/session/batch_runner.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

namespace test_batch_runner {

using namespace sparkout;

namespace {

/// Keeps what a runner reports.
struct Listener {
    explicit Listener(BatchRunner& runner) {
        QObject::connect(&runner, &BatchRunner::finished, &runner,
                         [this](const BatchOutcomePtr& outcome) { outcomes.push_back(outcome); });
        QObject::connect(&runner, &BatchRunner::progressed, &runner,
                         [this](qint64 done, qint64 parts, double left_s) {
                             told.push_back({done, parts, left_s});
                         });
    }
    struct Progress {
        qint64 done, parts;
        double left_s;
    };
    std::vector<BatchOutcomePtr> outcomes;
    std::vector<Progress> told;
};

constexpr int patience_ms = 60'000;
constexpr int endless = 1'000'000; ///< parts: a minute or so

} // namespace

class TestBatchRunner : public QObject {
    Q_OBJECT

private slots:
    /// A factor that joins is correlated with none, and takes its row and its column when it goes.
    void aFactorJoinsAndLeavesTheCorrelations() {
        Project project = newProject(Operation::traverse);
        project.batch.emplace();
        project.batch->factors.stock_mm.emplace().uniform = {0.14, 0.16};
        project.batch->factors.flow_stress_mpa.emplace().normal = {2000, 50};
        const std::vector<std::vector<double>> two{{1, 0.5}, {0.5, 1}};
        project.batch->correlation = two;
        Factor runout;
        runout.uniform = {0.01, 0.02};
        const Project more = withFactor(project, FactorKind::runout, runout);
        QVERIFY(more.batch->correlation
                == (std::vector<std::vector<double>>{{1, 0, 0.5}, {0, 1, 0}, {0.5, 0, 1}}));
        const Project fewer = withFactor(more, FactorKind::runout, std::nullopt);
        QVERIFY(fewer.batch->correlation == two);
    }

    /// What was kept since the batch was run is no part's: it stays with the user's project.
    void aPartTakenOverLeavesTheKeptRuns() {
        const Project project = fixtures::shaftBatch(3);
        const BatchResult batch = runBatch(project);
        Project now = project;
        now.runs = {{"before", "2026-01-01T00:00:00Z", "0.1", {"{}"}, {"{}"}}};
        now.notes = "mine";
        const Project part = withPart(now, batch, 1);
        QVERIFY(part.runs == now.runs);
        QCOMPARE(part.notes, now.notes);
        QVERIFY(part.part->stock_mm != project.part->stock_mm);
    }

    /// The ends of a law are three deviations from its middle.
    void aLawMadeNormalHasItsEndsAtThreeDeviations() {
        Project project = fixtures::shaftBatch(3);
        project.batch->factors.stock_mm = fixtures::uniform(0.12, 0.18);
        const Factor made = withForm(project, FactorKind::stock, FactorForm::normal);
        QVERIFY(made.normal && made.normal->size() == 2 && made.within);
        QCOMPARE(made.normal->at(0), 0.15);
        QCOMPARE(made.normal->at(1), 0.01);
        QCOMPARE(made.within->at(0), 0.12);
        QCOMPARE(made.within->at(1), 0.18);
        QVERIFY(formOf(made) == FactorForm::normal);
    }

    void theOutcomeIsThatOfTheEngine() {
        const Project project = fixtures::shaftBatch(50);
        BatchRunner runner;
        Listener heard(runner);
        runner.start(project);
        QVERIFY(runner.running());
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QVERIFY(!runner.running());
        const BatchOutcome& outcome = *heard.outcomes.front();
        QVERIFY(outcome.ran() && outcome.result.status == BatchStatus::completed);
        QCOMPARE(writeBatchState(outcome.result), writeBatchState(runBatch(project)));
        QCOMPARE(outcome.summary.characteristics.size(), outcome.regressions.size());
    }

    void aBatchThatCannotBeRunSaysWhy() {
        Project project = fixtures::shaftBatch(50);
        project.batch->factors.dullness = fixtures::uniform(0.03, 0.01);
        BatchRunner runner;
        Listener heard(runner);
        runner.start(project);
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QVERIFY(!heard.outcomes.front()->ran());
        QCOMPARE(heard.outcomes.front()->result.statistics.parts, std::int64_t{0});
    }

    void progressRisesAndAStopKeepsWhatWasDone() {
        BatchRunner runner;
        Listener heard(runner);
        runner.start(fixtures::shaftBatch(endless));
        const auto toldThrice = [&heard] {
            return heard.told.size() >= 3 && heard.told[2].done > 0;
        };
        QTRY_VERIFY_WITH_TIMEOUT(toldThrice(), patience_ms);
        for (std::size_t i = 1; i < heard.told.size(); ++i) {
            QVERIFY(heard.told[i].done >= heard.told[i - 1].done);
            QCOMPARE(heard.told[i].parts, qint64{endless});
        }
        QVERIFY(heard.told.back().left_s > 0);
        runner.stop();
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        const BatchOutcome& outcome = *heard.outcomes.front();
        QVERIFY(outcome.result.status == BatchStatus::stopped);
        QVERIFY(outcome.summary.parts >= heard.told[2].done && outcome.summary.parts < endless);
    }

    void theNewestBatchWinsAndADroppedOneIsNeverHeardOf() {
        BatchRunner runner;
        Listener heard(runner);
        runner.start(fixtures::shaftBatch(endless));
        QTest::qWait(20);
        runner.start(fixtures::shaftBatch(20));
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QCOMPARE(heard.outcomes.front()->summary.parts, std::int64_t{20});
        runner.start(fixtures::shaftBatch(endless));
        QTest::qWait(20);
        runner.drop();
        QVERIFY(!runner.running());
        QTest::qWait(200);
        QCOMPARE(heard.outcomes.size(), std::size_t{1});
    }

    void closingEndsItAndWaits() {
        QElapsedTimer timer;
        {
            BatchRunner runner;
            runner.start(fixtures::shaftBatch(endless));
            QTest::qWait(50);
            timer.start();
        }
        QVERIFY(timer.elapsed() < 5000); // a minute, if it did not end
    }
};

} // namespace test_batch_runner

SPARKOUT_TEST(test_batch_runner, TestBatchRunner)
#include "test_batch_runner.moc"
