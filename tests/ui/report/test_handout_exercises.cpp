// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The questions of the course hand-out, run again, and the page of their answers.
#include "core/file/project_file.h"
#include "core/simulation/simulate.h"
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "tests/ui/support/report_reading.h"
#include "ui/report/exercises.h"
#include "ui/report/format/pages.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace sparkout::test_handout_exercises {

using namespace handout_bench;

QString onOneLine(QString text) {
    return text.replace(QChar::Nbsp, u' ').simplified();
}

/// What is asked for, read off a run by this test.
double measured(Asked asked, const SimulationResult& result, const Visit* visit) {
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

constexpr Asked everything[] = {Asked::stepFeed_um, Asked::stepForce_n, Asked::time_min,
                                Asked::count,       Asked::spread_um,   Asked::runout_um,
                                Asked::peakForce_n, Asked::peakPower_kw};

/// "stage 2 takes 4.12 s less" against the stages of both runs.
void checkStageTimes(const QString& reason, const SimulationResult& was, const SimulationResult& is,
                     const QString& language) {
    static const QRegularExpression english(
        QStringLiteral("stage (\\d) takes ([0-9.]+)[ \u00a0](min|s) (longer|less)"));
    static const QRegularExpression russian(
        QStringLiteral("ступень (\\d) (длиннее|короче) на ([0-9,]+)[ \u00a0](мин|с)"));
    const bool isEnglish = language == u"en";
    int count = 0;
    for (auto it = (isEnglish ? english : russian).globalMatch(reason); it.hasNext(); ++count) {
        const auto found = it.next();
        const auto z = static_cast<std::size_t>(found.captured(1).toInt() - 1);
        const double said = QLocale().toDouble(found.captured(isEnglish ? 2 : 3));
        const bool longer = found.captured(isEnglish ? 4 : 2)
                            == (isEnglish ? QStringLiteral("longer") : QStringLiteral("длиннее"));
        const QString unit = found.captured(isEnglish ? 3 : 4);
        const double more =
            (is.timeByStage_s.at(z) - was.timeByStage_s.at(z)) / (unit == unitText("s") ? 1 : 60);
        QVERIFY2(std::abs((longer ? said : -said) - more) <= 0.006 * std::abs(more),
                 qPrintable(reason));
    }
    const bool ofTime = reason.contains(report::askedQuantity(Asked::time_min, Operation::plunge));
    QVERIFY2((count > 0) == ofTime, qPrintable(reason));
}

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
                QCOMPARE(*now.cycle->stages[1].radial_feed_mm,
                         0.5 * *before.cycle->stages[1].radial_feed_mm);
            } else if (changed.last() == u"/part/stock_mm") {
                const double more = 0.2 * before.part->stock_mm;
                QCOMPARE(now.part->stock_mm, before.part->stock_mm + more);
                QCOMPARE(now.cycle->stages[0].stock_mm, before.cycle->stages[0].stock_mm + more);
                QCOMPARE(now.cycle->stages[1].stock_mm, before.cycle->stages[1].stock_mm);
            } else if (changed.last() == u"/part/initial_runout_mm") {
                QCOMPARE(now.part->initial_runout_mm, 2 * before.part->initial_runout_mm);
            } else if (changed.last() == u"/machine/compliance_mm_per_n") {
                const auto& was = std::get<ZoneCompliance>(before.machine->compliance_mm_per_n);
                const auto& is = std::get<ZoneCompliance>(now.machine->compliance_mm_per_n);
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

    void placesAreCalledByTheirNamesInTheOperation() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            const bool plunges = operation == Operation::plunge;
            Project project = plunges ? fixtures::plungeProject(2) : fixtures::traverseProject();
            if (plunges) {
                project.machine->compliance_mm_per_n = std::vector<double>{6e-5, 9e-5};
            }
            const auto exercises = report::makeExercises(*fixtures::run(project), std::nullopt);
            const auto told = [&](QLatin1StringView place) {
                return std::ranges::any_of(exercises, [&](const report::Exercise& exercise) {
                    return onOneLine(exercise.question).contains(place);
                });
            };
            QCOMPARE(told(QLatin1StringView("in every zone")), !plunges);
            QCOMPARE(told(QLatin1StringView("in every section")), plunges);
        }
    }

    void unitsThatYieldMoreAreLessStiff() {
        Project project = fixtures::traverseProject();
        project.part->shaft.segments = {{150, 30}};
        project.part->shaft.ground_from_mm = 29;
        project.machine->compliance_mm_per_n = std::monostate();
        project.machine->stiffness_n_um = Stiffness{60, 45, 30};
        const auto exercises = report::makeExercises(*fixtures::run(project), std::nullopt);
        const auto softer = std::ranges::find_if(exercises, [&](const report::Exercise& exercise) {
            return firstDifference(project, exercise.changed)
                   == "/machine/stiffness_n_um/headstock";
        });
        QVERIFY(softer != exercises.end());
        const Stiffness& stiffness = *softer->changed.machine->stiffness_n_um;
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
        QCOMPARE(askedValue(Asked::spread_um, result, nullptr).value_or(0), 14.0);
        std::swap(result.sections[0], result.sections[1]);
        QCOMPARE(askedValue(Asked::spread_um, result, nullptr).value_or(0), 14.0);
    }

    void theAnswersAreThoseOfTheChangedProject_data() { addCases(); }
    void theAnswersAreThoseOfTheChangedProject() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = exampleOutcome(path);
        const auto step = report::findStep(outcome->trajectory, report::usualStep());
        QVERIFY(step);
        const std::vector<report::Exercise> exercises = report::makeExercises(*outcome, step);
        QVERIFY(exercises.size() >= 3 && exercises.size() <= 5);
        const Operation operation = outcome->result.project.operation;
        const QString text =
            reading::textOfHtml(bytesOf(handout(outcome), Format::html)).simplified();
        for (const report::Exercise& exercise : exercises) {
            QVERIFY(!sameProject(exercise.changed, outcome->result.project));
            Trajectory trajectory;
            const SimulationResult result = simulate(exercise.changed, &trajectory);
            QCOMPARE(result.status, RunStatus::completed);
            QVERIFY(text.contains(onOneLine(exercise.question)));
            QVERIFY(text.contains(onOneLine(exercise.reason)));
            QVERIFY(!exercise.answers.empty());
            for (const ExerciseAnswer& answer : exercise.answers) {
                const auto visit = [&](const Trajectory& in) {
                    return exercise.at ? visitOf(in, *exercise.at, step->radius) : nullptr;
                };
                QCOMPARE(answer.before,
                         measured(answer.asked, outcome->result, visit(outcome->trajectory)));
                QCOMPARE(answer.after, measured(answer.asked, result, visit(trajectory)));
                const QString before = report::askedNumber(answer.asked, answer.before),
                              after = report::askedNumber(answer.asked, answer.after);
                const QString row = onOneLine(
                    QStringList{report::askedName(answer.asked, operation), before, after}.join(
                        u' '));
                QVERIFY2(text.contains(row), qPrintable(row));
                // the text beside the table says what the table says
                QVERIFY2(before != after, qPrintable(row));
                QVERIFY2(std::abs(answer.after - answer.before) >= 0.02 * answer.before,
                         qPrintable(row));
                const bool rises = answer.after > answer.before;
                const QString said = report::movedText(answer.asked, operation, rises);
                QVERIFY2(exercise.reason.contains(said), qPrintable(said + exercise.reason));
                QVERIFY2(
                    !exercise.reason.contains(report::movedText(answer.asked, operation, !rises)),
                    qPrintable(exercise.reason));
            }
            for (const Asked asked : everything) {
                if (std::ranges::none_of(exercise.answers,
                                         [&](const auto& a) { return a.asked == asked; })) {
                    const QString name = report::askedQuantity(asked, operation);
                    QVERIFY2(!exercise.question.contains(name, Qt::CaseInsensitive)
                                 && !exercise.reason.contains(name),
                             qPrintable(exercise.question + exercise.reason));
                }
            }
            checkStageTimes(exercise.reason, outcome->result, result, language);
        }
    }

    void whatCannotBeReadIsNotAsked() {
        for (const auto& [asked, before, after, read] :
             {std::tuple(Asked::runout_um, 0.0, 0.0, false),
              std::tuple(Asked::runout_um, 1.03, 1.12, false), // less than a gauge shows
              std::tuple(Asked::runout_um, 1.03, 1.23, true),
              std::tuple(Asked::time_min, 19.23, 19.08, false),
              std::tuple(Asked::time_min, 19.23, 18.08, true),
              std::tuple(Asked::count, 20.0, 21.0, false), // the phase of the gauge
              std::tuple(Asked::count, 20.0, 22.0, true),
              std::tuple(Asked::peakPower_kw, 2.07, 2.07, false)}) {
            QCOMPARE(canBeRead({asked, before, after}), read);
        }
        Project stiff = fixtures::traverseProject();
        stiff.machine->compliance_mm_per_n = ZoneCompliance{1e-9, 1e-9, 1e-9};
        for (const report::Exercise& exercise :
             report::makeExercises(*fixtures::run(stiff), std::nullopt)) {
            QVERIFY2(
                !std::holds_alternative<ZoneCompliance>(
                    exercise.changed.machine->compliance_mm_per_n)
                    || std::get<ZoneCompliance>(exercise.changed.machine->compliance_mm_per_n).nz
                           == 1e-9,
                qPrintable(exercise.question));
        }
    }

    void aCycleThatDoesNotReachSizeIsNotAskedAbout() {
        Outcome outcome = *fixtures::run(fixtures::traverseProject());
        const auto step = report::findStep(outcome.trajectory);
        QVERIFY(!report::makeExercises(outcome, step).empty());
        outcome.result.status = RunStatus::cannotReachSize;
        QVERIFY(report::makeExercises(outcome, step).empty());
    }

    void anUncalibratedRoughnessLimitsNoDepth_data() { addCases(); }
    void anUncalibratedRoughnessLimitsNoDepth() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr guessed = exampleOutcome(path);
        Project measured = guessed->result.project;
        if (!measured.part->tolerance.roughness_ra_um || measured.wheel->roughness_factor != 1) {
            QSKIP("nothing is required of Ra, or it is calibrated");
        }
        measured.wheel->roughness_factor = 2.5;
        const auto roughnessRows = [](const OutcomePtr& outcome) {
            const auto rows = reading::rowsOfHtml(
                bytesOf(handout(outcome, {.views = {}, .answers = false}), Format::html));
            return std::ranges::count_if(rows, [](const QStringList& row) {
                return row.front() == Names::constraint(ConstraintKind::roughness);
            });
        };
        QCOMPARE(roughnessRows(guessed), 0);
        QCOMPARE(roughnessRows(fixtures::run(measured)), 1);
        const QString text = reading::textOfHtml(
            bytesOf(handout(guessed, {.views = {}, .answers = false}), Format::html));
        QVERIFY(text.contains(language == u"en" ? QStringLiteral("Roughness is not limiting")
                                                : QStringLiteral("Шероховатость не ограничивает")));
    }

    void theFirstQuestionDullsTheWheelAndNothingElse() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const auto exercises =
            report::makeExercises(*outcome, report::findStep(outcome->trajectory));
        Project changed = exercises.front().changed;
        QCOMPARE(changed.wheel->dullness, 2 * outcome->result.project.wheel->dullness);
        changed.wheel->dullness = outcome->result.project.wheel->dullness;
        QVERIFY(sameProject(changed, outcome->result.project));
        const auto force = std::ranges::find_if(exercises.front().answers, [](const auto& answer) {
            return answer.asked == Asked::stepForce_n;
        });
        QVERIFY(force != exercises.front().answers.end() && force->after > force->before);
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

} // namespace sparkout::test_handout_exercises

SPARKOUT_TEST(test_handout_exercises, TestHandoutExercises)
#include "test_handout_exercises.moc"
