// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of the course hand-out, run again, and the page of their answers.
#include "core/project/project_file.h"
#include "core/simulation/simulate.h"
#include "tests/registry.h"
#include "tests/ui/handout_bench.h"
#include "tests/ui/report_reading.h"
#include "ui/report/exercises.h"
#include "ui/report/pages.h"
#include "ui/session/difference.h"

#include <algorithm>
#include <utility>

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

    void eachQuestionChangesItsInputByTheShareItNames() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const Project& before = outcome->result.project;
        QStringList changed;
        for (const report::Exercise& exercise : report::makeExercises(*outcome, std::nullopt)) {
            const Project& now = exercise.changed;
            changed << QString::fromStdString(firstDifference(before, now));
            if (changed.last() == u"/cycle/stages/1/radial_feed_mm") { // of the last stage
                QCOMPARE(*now.cycle.stages[1].radial_feed_mm,
                         0.5 * *before.cycle.stages[1].radial_feed_mm);
            } else if (changed.last() == u"/part/stock_mm") {
                const double more = 0.2 * before.part.stock_mm;
                QCOMPARE(now.part.stock_mm, before.part.stock_mm + more);
                QCOMPARE(now.cycle.stages[0].stock_mm, before.cycle.stages[0].stock_mm + more);
                QCOMPARE(now.cycle.stages[1].stock_mm, before.cycle.stages[1].stock_mm);
            } else if (changed.last() == u"/part/initial_runout_mm") {
                QCOMPARE(now.part.initial_runout_mm, 2 * before.part.initial_runout_mm);
            } else if (changed.last() == u"/machine/compliance_mm_per_n") {
                const auto& was = std::get<ZoneCompliance>(before.machine.compliance_mm_per_n);
                const auto& is = std::get<ZoneCompliance>(now.machine.compliance_mm_per_n);
                QCOMPARE(is.rz1, 1.5 * was.rz1);
                QCOMPARE(is.nz, 1.5 * was.nz);
                QCOMPARE(is.rz2, 1.5 * was.rz2);
            }
        }
        changed.sort();
        QCOMPARE(changed, (QStringList{QStringLiteral("/cycle/stages/1/radial_feed_mm"),
                                       QStringLiteral("/machine/compliance_mm_per_n"),
                                       QStringLiteral("/part/initial_runout_mm"),
                                       QStringLiteral("/part/stock_mm"),
                                       QStringLiteral("/wheel/dullness")}));
    }

    /// What yields more is less stiff.
    void unitsThatYieldMoreAreLessStiff() {
        Project project = fixtures::traverseProject();
        project.part.shaft.segments = {{150, 30}};
        project.part.shaft.ground_from_mm = 29;
        project.machine.compliance_mm_per_n = std::monostate();
        project.machine.stiffness_n_um = Stiffness{60, 45, 30};
        const auto exercises = report::makeExercises(*fixtures::run(project), std::nullopt);
        const auto softer = std::ranges::find_if(exercises, [&](const report::Exercise& exercise) {
            return firstDifference(project, exercise.changed)
                   == "/machine/stiffness_n_um/headstock";
        });
        QVERIFY(softer != exercises.end());
        const Stiffness& stiffness = *softer->changed.machine.stiffness_n_um;
        QCOMPARE(stiffness.headstock, 40.0);
        QCOMPARE(stiffness.tailstock, 30.0);
        QCOMPARE(stiffness.wheel_head, 20.0);
    }

    /// The zone with the smallest diameter need not be the one whose largest is the least.
    void theSpreadIsFromTheSmallestOfAllDiametersToTheLargest() {
        SimulationResult result;
        result.sections.resize(2);
        result.sections[0].diameterDeviationMin_mm = -0.005;
        result.sections[0].diameterDeviationMax_mm = 0.009;
        result.sections[1].diameterDeviationMin_mm = -0.002;
        result.sections[1].diameterDeviationMax_mm = 0.001;
        QCOMPARE(report::askedValue(report::Asked::spread_um, result, nullptr).value_or(0), 14.0);
        std::swap(result.sections[0], result.sections[1]);
        QCOMPARE(report::askedValue(report::Asked::spread_um, result, nullptr).value_or(0), 14.0);
    }

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
