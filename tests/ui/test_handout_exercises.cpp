// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of the course hand-out, run again, and the page of their answers.
#include "core/project/project_file.h"
#include "core/simulation/simulate.h"
#include "tests/registry.h"
#include "tests/ui/handout_bench.h"
#include "tests/ui/report_reading.h"
#include "ui/report/exercises.h"
#include "ui/report/pages.h"

#include <algorithm>

namespace test_handout_exercises {

using namespace sparkout;
using namespace handout_bench;

namespace {

QString onOneLine(QString text) {
    return text.replace(QChar::Nbsp, u' ').simplified();
}

/// What is asked for, read off a run by this test.
double measured(report::Asked asked, const SimulationResult& result, const Visit* visit) {
    using report::Asked;
    double low = 1e9, high = -1e9, runout = 0;
    for (const SectionResult& section : result.sections) {
        low = std::min(low, section.diameterDeviationMin_mm);
        high = std::max(high, section.diameterDeviationMax_mm);
        runout = std::max(runout, section.radialRunout_mm);
    }
    switch (asked) {
    case Asked::stepFeed_um: return visit->actual_mm * 1000;
    case Asked::stepForce_n: return visit->normalForce_n;
    case Asked::time_min: return result.time_s / 60;
    case Asked::count: return result.cycleCount;
    case Asked::spread_um: return (high - low) * 1000;
    case Asked::runout_um: return runout * 1000;
    case Asked::peakForce_n: return result.peakNormalForce_n;
    case Asked::peakPower_kw: return result.peakPower_w / 1000;
    }
    return 0;
}

} // namespace

class TestHandoutExercises : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void theAnswersAreThoseOfTheChangedProject_data() { addCases({"en"}); }
    void theAnswersAreThoseOfTheChangedProject() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = exampleOutcome(path);
        const auto step = report::findStep(outcome->trajectory, report::usualStep());
        QVERIFY(step);
        const std::vector<report::Exercise> exercises = report::makeExercises(*outcome, step);
        QVERIFY(exercises.size() >= 3 && exercises.size() <= 5);
        const QString text =
            reading::textOfHtml(bytesOf(handout(outcome), Format::html)).simplified();
        for (const report::Exercise& exercise : exercises) {
            QVERIFY(!sameProject(exercise.changed, outcome->result.project));
            Trajectory trajectory;
            const SimulationResult result = simulate(exercise.changed, &trajectory);
            QCOMPARE(exercise.status, result.status);
            QVERIFY(text.contains(onOneLine(exercise.question)) && exercise.answers.size() >= 3);
            for (const report::Answer& answer : exercise.answers) {
                const auto visit = [&](const Trajectory& in) {
                    return exercise.at ? visitOf(in, *exercise.at, step->radius) : nullptr;
                };
                QCOMPARE(answer.before,
                         measured(answer.asked, outcome->result, visit(outcome->trajectory)));
                QCOMPARE(answer.after, measured(answer.asked, result, visit(trajectory)));
                const QString row = onOneLine(
                    QStringList{askedName(answer.asked, outcome->result.project.operation),
                                askedNumber(answer.asked, answer.before),
                                askedNumber(answer.asked, answer.after)}
                        .join(u' '));
                QVERIFY2(text.contains(row), qPrintable(row));
            }
        }
    }

    void theFirstQuestionDullsTheWheelAndNothingElse() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const auto exercises =
            report::makeExercises(*outcome, report::findStep(outcome->trajectory));
        Project changed = exercises.front().changed;
        QCOMPARE(changed.wheel.dullness, 2 * outcome->result.project.wheel.dullness);
        changed.wheel.dullness = outcome->result.project.wheel.dullness;
        QVERIFY(sameProject(changed, outcome->result.project));
        const report::Answer& force = exercises.front().answers.at(1);
        QCOMPARE(force.asked, report::Asked::stepForce_n);
        QVERIFY(force.after > force.before);
    }

    void theKeyIsALastPageOfItsOwnAndCanBeLeftOut() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const auto pagesOf = [&](bool answers) {
            const HandoutOptions options{.answers = answers};
            return reading::textOf(bytesOf(handout(outcome, options), Format::pdf))
                .split(u'\f', Qt::SkipEmptyParts);
        };
        const QStringList with = pagesOf(true), without = pagesOf(false);
        QCOMPARE(with.size(), without.size() + 1);
        const QStringList last = with.last().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(last.value(0).trimmed(), QStringLiteral("Answers")); // nothing names the part
        for (const QString& page : without) {
            QVERIFY(!page.contains(QStringLiteral("Answers")));
            QVERIFY(!page.contains(QStringLiteral("Difference, %")));
        }
    }

private:
    Language m_language;
};

} // namespace test_handout_exercises

SPARKOUT_TEST(test_handout_exercises, TestHandoutExercises)
#include "test_handout_exercises.moc"
