// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The headline of the verdict panel: each state with its words and its mark.
#include "tests/registry.h"
#include "tests/ui/views/requirements/verdict_bench.h"
#include "ui/results/verdict_table.h"
#include "ui/session/run_controller.h"
#include "ui/text/judgement_text.h"
#include "ui/text/language.h"

#include <QImage>
#include <QPixmap>

namespace sparkout::test_verdict_judged {

using namespace verdict_bench;
using verdict_bench::Bench;

/// How the plunge of the bench may stand.
JudgedRun judgedAs(const OutcomePtr& outcome, JudgedState state) {
    JudgedRun judged;
    judged.outcome = outcome;
    Judgement& judgement = judged.judgement;
    judgement.state = state;
    judgement.status = RunStatus::completed;
    ConstraintResult worst{ConstraintKind::diameterMin};
    worst.margin = state == JudgedState::close ? 0.64 : -10.7;
    worst.relativeMargin = worst.margin / 16;
    worst.holds = state == JudgedState::close;
    judgement.worst = worst;
    judgement.stocks = JudgedStocks{{0.149, 0.151},
                                    state != JudgedState::stocksFail,
                                    state == JudgedState::stocksFail ? 0.34 : 0,
                                    RunStatus::completed,
                                    worst};
    const std::int64_t bad = state == JudgedState::batchFails ? 17 : 0;
    if (state != JudgedState::batchNotRun) {
        judgement.batch = JudgedBatch{50, bad, 1, clopperPearson(bad, 50, 0.95), 0, true};
    }
    judgement.measured = MeasuredBias{ConstraintKind::diameterMin, Zone::section, 1, 8.2};
    judgement.notDecided = {
        {ConstraintKind::roughness, UndecidedReason::notCalibrated, "/wheel/roughness_factor"}};
    judged.hasBatch = true;
    return judged;
}

class TestVerdictJudged : public VerdictTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void headlineSaysEachState_data() {
        addColumns<int, QString>("state", "words");
        const auto row = [](JudgedState state, const char* words) {
            QTest::newRow(stateKey(state)) << static_cast<int>(state) << QString::fromUtf8(words);
        };
        row(JudgedState::fails, "Not met: minimum diameter by 10.70 µm");
        row(JudgedState::stocksFail, "Unfit for 34 % of stocks: minimum diameter by 10.70 µm");
        row(JudgedState::batchFails, "Rejects in the batch: 17 of 50 (21…49 %)");
        row(JudgedState::measuredDiffer, "Met, but measured parts differ from the prediction: "
                                         "diameter, Section 2, by +8.20 µm");
        row(JudgedState::undecided, "Met, except roughness Ra: not decided");
        row(JudgedState::close, "Met, close to the limit: minimum diameter, 4.0 %");
        row(JudgedState::batchNotRun, "Fit for every stock; batch not run");
        row(JudgedState::batchHolds, "Fit for the batch: rejected 0 of 50 (≤ 7.1 %)");
        row(JudgedState::stocksHold, "Fit for every stock");
        row(JudgedState::nominal, "Nominal part only");
    }
    void headlineSaysEachState() {
        QFETCH(int, state);
        QFETCH(QString, words);
        Bench bench(m_plunge);
        bench.panel.setJudged(judgedAs(m_plunge, static_cast<JudgedState>(state)));
        QCOMPARE(bench.label("overall").text().replace(u'\u00a0', u' '), words);
        QVERIFY(bench.label("judgedStocks").isVisible());
        QVERIFY(bench.label("judgedBatch").isVisible());
        const bool isOfMoreParts =
            words.contains(QStringLiteral("tock")) || words.contains(QStringLiteral("batch"));
        QCOMPARE(bench.label("partOnly").text(), QStringLiteral("Part as stated:"));
        QCOMPARE(!bench.label("partOnly").isHidden(), isOfMoreParts); // the table is of it alone
    }

    /// Distinct without colour, too; the states of one light share their mark.
    void marksOfTheStatesDiffer() {
        const auto image = [](JudgedState state) {
            return judgedPixmap(state, 32, 1, false).toImage();
        };
        QVERIFY(image(JudgedState::fails) == image(JudgedState::batchFails));
        QVERIFY(image(JudgedState::fails) == image(JudgedState::stocksFail));
        QVERIFY(image(JudgedState::undecided) == image(JudgedState::close));
        QVERIFY(image(JudgedState::undecided) == image(JudgedState::measuredDiffer));
        QVERIFY(image(JudgedState::batchHolds) == image(JudgedState::stocksHold));
        QVERIFY(image(JudgedState::batchNotRun) == image(JudgedState::nominal));
        const std::vector<JudgedState> marks{JudgedState::notComputed, JudgedState::fails,
                                             JudgedState::close, JudgedState::stocksHold,
                                             JudgedState::nominal};
        for (std::size_t i = 0; i < marks.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                QVERIFY(image(marks[i]).convertToFormat(QImage::Format_Alpha8)
                        != image(marks[k]).convertToFormat(QImage::Format_Alpha8));
            }
        }
    }

    /// Without more the part that was run is judged alone.
    void outcomeAloneIsOfTheNominalPart() {
        Project project = plungeProject(3);
        project.part->tolerance.radial_runout_um.reset();
        project.part->upper_deviation_um = 900;
        project.part->lower_deviation_um = -900;
        Bench bench(run(project));
        QCOMPARE(bench.label("overall").text(), QStringLiteral("Nominal part only"));
        QVERIFY(!bench.label("judgedStocks").isVisible());
        QVERIFY(!bench.label("judgedBatch").isVisible());
    }

    void whatIsToComeIsGreyAndSaysSo() {
        Bench bench(m_plunge);
        JudgedRun judged = judgedAs(m_plunge, JudgedState::nominal);
        judged.judgement.stocks.reset();
        judged.judgement.batch.reset();
        judged.areStocksComing = judged.isBatchComing = true;
        bench.panel.setJudged(judged);
        QCOMPARE(bench.label("judgedStocks").text(), QStringLiteral("Stocks: being decided"));
        QCOMPARE(bench.label("judgedBatch").text(), QStringLiteral("Batch: being run"));
        QVERIFY(!bench.label("judgedStocks").isEnabled());
        QVERIFY(!bench.label("judgedBatch").isEnabled());
        bench.panel.setJudged(judgedAs(m_plunge, JudgedState::batchHolds));
        QCOMPARE(bench.label("judgedStocks").text(),
                 QStringLiteral("Every stock per side 0.1490…0.1510 mm: fit"));
        QCOMPARE(bench.label("judgedBatch").text(),
                 QStringLiteral("Batch: rejected 0 of 50 (≤ 7.1 %)"));
        QVERIFY(bench.label("judgedStocks").isEnabled());
        QVERIFY(bench.label("judgedBatch").isEnabled());
    }

    /// Of the inputs before: it stands in grey beside the last good numbers.
    void refusedInputsLeaveTheLastJudgementInGrey() {
        Bench bench(m_plunge);
        bench.panel.setJudged(judgedAs(m_plunge, JudgedState::stocksHold));
        auto refused = std::make_shared<Outcome>();
        refused->issues.push_back({IssueCode::missingKey, Severity::error, "/part", {}, {}});
        JudgedRun none;
        none.outcome = refused;
        bench.panel.setOutcome(refused);
        bench.panel.setJudged(none);
        QTRY_VERIFY(!bench.label("judgedStocks").isEnabled());
        QCOMPARE(bench.label("overall").text(),
                 QStringLiteral("Fit for every stock (before the last edit)"));
    }

    void russianHasTheSameStates() {
        Language language;
        language.apply(QStringLiteral("ru"));
        const auto said = [this](JudgedState state) {
            QString text = JudgementText::headline(judgedAs(m_plunge, state).judgement);
            return text.replace(u'\u00a0', u' ');
        };
        QCOMPARE(said(JudgedState::stocksHold), QStringLiteral("Годен для всех припусков"));
        QCOMPARE(said(JudgedState::batchNotRun),
                 QStringLiteral("Годен для всех припусков; партия не рассчитана"));
        QCOMPARE(said(JudgedState::batchFails),
                 QStringLiteral("Брак в партии: 17 из 50 (21…49 %)"));
        QCOMPARE(said(JudgedState::batchHolds),
                 QStringLiteral("Годен для партии: брак 0 из 50 (≤ 7,1 %)"));
        QCOMPARE(said(JudgedState::nominal), QStringLiteral("Только номинальная деталь"));
        QCOMPARE(said(JudgedState::fails),
                 QStringLiteral("Не выполнено: наим. диаметр на 10,70 мкм"));
        language.apply(QStringLiteral("en"));
        QLocale::setDefault(QLocale::c());
    }
};

} // namespace sparkout::test_verdict_judged

SPARKOUT_TEST(test_verdict_judged, TestVerdictJudged)
#include "test_verdict_judged.moc"
