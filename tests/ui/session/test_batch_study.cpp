// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_state.h"
#include "core/study/batch_edits.h"
#include "core/study/new_project.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "tests/ui/support/traced_project.h"
#include "ui/session/studies.h"

#include <QElapsedTimer>

namespace sparkout::test_batch_study {

/// A study of batches, and what it reports.
struct Heard {
    Heard() {
        QObject::connect(&study().job(), &Job::answered, &study().job(), [this] {
            if (!study().running()) {
                outcomes.push_back(study().refusal() ? study().refusal() : study().result());
            }
        });
        QObject::connect(&study().job(), &Job::progressed, &study().job(),
                         [this](qint64 done, qint64 parts, double left_s) {
                             told.push_back({done, parts, left_s});
                         });
    }
    StudyOf<BatchOutcome>& study() { return studies.batch; }
    struct Progress {
        qint64 done, parts;
        double left_s;
    };
    std::vector<BatchOutcomePtr> outcomes;
    std::vector<Progress> told;
    Studies studies; ///< last: ended before what it reports to is gone
};

constexpr int patience_ms = 60'000;
constexpr int endless = 1'000'000; ///< parts: a minute or so

class TestBatchStudy : public QObject {
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
        Heard heard;
        heard.studies.runBatch(project);
        QVERIFY(heard.study().running());
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QVERIFY(!heard.study().running());
        const BatchOutcome& outcome = *heard.outcomes.front();
        QVERIFY(outcome.ran() && outcome.result.status == BatchStatus::completed);
        QCOMPARE(writeBatchState(outcome.result), writeBatchState(runBatch(project)));
        QCOMPARE(outcome.summary.characteristics.size(), outcome.regressions.size());
    }

    void aBatchThatCannotBeRunSaysWhy() {
        Project project = fixtures::shaftBatch(50);
        project.batch->factors.dullness = fixtures::uniform(0.03, 0.01);
        Heard heard;
        heard.studies.runBatch(project);
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QVERIFY(!heard.outcomes.front()->ran());
        QCOMPARE(heard.outcomes.front()->result.statistics.parts, std::int64_t{0});
    }

    void progressRisesAndAStopKeepsWhatWasDone() {
        Heard heard;
        heard.studies.runBatch(fixtures::shaftBatch(endless));
        const auto toldThrice = [&heard] {
            return heard.told.size() >= 3 && heard.told[2].done > 0;
        };
        QTRY_VERIFY_WITH_TIMEOUT(toldThrice(), patience_ms);
        for (std::size_t i = 1; i < heard.told.size(); ++i) {
            QVERIFY(heard.told[i].done >= heard.told[i - 1].done);
            QCOMPARE(heard.told[i].parts, qint64{endless});
        }
        QVERIFY(heard.told.back().left_s > 0);
        heard.study().job().stop();
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        const BatchOutcome& outcome = *heard.outcomes.front();
        QVERIFY(outcome.result.status == BatchStatus::stopped);
        QVERIFY(outcome.summary.parts >= heard.told[2].done && outcome.summary.parts < endless);
    }

    void theNewestBatchWinsAndADroppedOneIsNeverHeardOf() {
        Heard heard;
        heard.studies.runBatch(fixtures::shaftBatch(endless));
        QTest::qWait(20);
        heard.studies.runBatch(fixtures::shaftBatch(20));
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QCOMPARE(heard.outcomes.front()->summary.parts, std::int64_t{20});
        heard.studies.runBatch(fixtures::shaftBatch(endless));
        QTest::qWait(20);
        heard.study().job().drop();
        QVERIFY(!heard.study().running());
        QTest::qWait(200);
        QCOMPARE(heard.outcomes.size(), std::size_t{1});
    }

    /// A result of other inputs is stale; a run of other inputs is dropped, one of these goes on.
    void itFollowsTheInputs() {
        Heard heard;
        const Project project = fixtures::shaftBatch(20);
        QVERIFY(heard.study().stale());
        heard.study().follow(&project);
        heard.studies.runBatch(project);
        heard.study().follow(&project);
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{1}, patience_ms);
        QVERIFY(!heard.study().stale() && heard.study().isOf(project));
        Project other = project;
        other.title = "nothing that counts";
        heard.study().follow(&other);
        QVERIFY(!heard.study().stale());
        other.wheel->dullness += 0.001;
        heard.study().follow(&other);
        QVERIFY(heard.study().stale() && heard.study().result());
        heard.studies.runBatch(fixtures::shaftBatch(endless));
        heard.study().follow(&other);
        QVERIFY(!heard.study().running());
        other.batch->factors.dullness = fixtures::uniform(0.03, 0.01);
        heard.studies.runBatch(other);
        QTRY_COMPARE_WITH_TIMEOUT(heard.outcomes.size(), std::size_t{2}, patience_ms);
        QVERIFY(heard.study().refusal() && heard.study().result()); // that of before stays
        heard.study().follow(&project);
        QVERIFY(!heard.study().refusal() && !heard.study().stale());
        heard.study().forget();
        QVERIFY(heard.study().stale() && !heard.study().result());
    }

    /// What an unused trace says belongs to its inputs alone.
    void unusedTracesFollowTheInputs() {
        const Project project = traced::heldOut();
        const std::vector<HoldOutRow> rows = holdOut(project);
        QVERIFY(!rows.empty());
        Studies studies;
        studies.heldOut.follow(&project);
        QVERIFY(studies.heldOut.stale() && studies.currentHeldOut().empty());
        studies.runHoldOut(project);
        QVERIFY(studies.heldOut.running());
        QTRY_VERIFY_WITH_TIMEOUT(!studies.heldOut.running(), patience_ms);
        QCOMPARE(studies.currentHeldOut().size(), rows.size());
        QCOMPARE(studies.currentHeldOut().front().measured, rows.front().measured);
        QCOMPARE(studies.currentHeldOut().front().predicted, rows.front().predicted);
        Project other = project;
        other.measured->traces.pop_back();
        studies.heldOut.follow(&other);
        QVERIFY(studies.currentHeldOut().empty());
        studies.runHoldOut(project);
        studies.heldOut.follow(&other);
        QVERIFY(!studies.heldOut.running()); // it was of other inputs
        studies.runHoldOut(other);
        QTRY_VERIFY_WITH_TIMEOUT(!studies.heldOut.stale(), patience_ms);
        QVERIFY(studies.currentHeldOut().empty()); // nothing is left unused
        studies.heldOut.forget();
        QVERIFY(studies.heldOut.stale());
    }

    void closingEndsItAndWaits() {
        QElapsedTimer timer;
        {
            Studies studies;
            studies.runBatch(fixtures::shaftBatch(endless));
            QTest::qWait(50);
            timer.start();
        }
        QVERIFY(timer.elapsed() < 5000); // a minute, if it did not end
    }
};

} // namespace sparkout::test_batch_study

SPARKOUT_TEST(test_batch_study, TestBatchStudy)
#include "test_batch_study.moc"
