// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/exercises.h"

#include "core/process/force.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "ui/report/cell_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace sparkout::report {

namespace {

constexpr double digitsKept = 1e6;

constexpr double leastTime_min = 5e-4; ///< least time of a stage

struct ExerciseText {
    Q_DECLARE_TR_FUNCTIONS(Exercises)
};

/// The reason why an answer changes in this direction; used only then.
struct Why {
    Asked asked;
    bool rises;
    QString text;
};

/// The texts about a change.
struct ChangeWords {
    QString statement;
    std::vector<Why> why;
    bool moreLag = false; ///< the lag of the system behind its feed increases
};

const char* unitOf(Asked asked) {
    switch (asked) {
    case Asked::stepFeed_um:
    case Asked::spread_um:
    case Asked::runout_um: return "µm";
    case Asked::stepForce_n:
    case Asked::peakForce_n: return "N";
    case Asked::peakPower_kw: return "kW";
    case Asked::time_min: // the reason of the time is composed separately
    case Asked::count: break;
    }
    return "";
}

QString mm(double value) {
    return withUnit(printedNumber(value), "mm");
}

ChangeWords duller(const Project& project, const ExerciseRun& run) {
    return {ExerciseText::tr("The wheel has become dull: η rises from %1 to %2.")
                .arg(printedNumber(dullnessOf(*project.wheel)),
                     printedNumber(dullnessOf(*run.changed.wheel))),
            {{Asked::stepFeed_um, false, ExerciseText::tr("less is cut at the same lag")},
             {Asked::stepForce_n, true,
              ExerciseText::tr("the friction of the wear flats, kr·√a, grows with η")}},
            true};
}

ChangeWords softer(const Project& project, const ExerciseRun&) {
    const bool isComputed =
        std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
    const QString statement =
        isComputed
            ? ExerciseText::tr("The units of the machine yield %1 times as much under the same "
                               "force.")
        : project.operation->travels
            ? ExerciseText::tr("The technological system is %1 times as compliant in every zone.")
            : ExerciseText::tr("The technological system is %1 times as compliant in every "
                               "section.");
    return {statement.arg(printedNumber(softerBy)),
            {{Asked::spread_um, true,
              ExerciseText::tr("a place differs in diameter from the one with the gauge by "
                               "twice the difference of their deflections γ·Py at the end")},
             {Asked::peakForce_n, false,
              ExerciseText::tr("the lag takes longer to build up, and the stage is over "
                               "before the force of its feed is reached")}},
            true};
}

ChangeWords slower(const Project& project, const ExerciseRun& run) {
    const StageFeed& radial = project.operation->radial();
    const auto feedOf = [&](const Project& of) {
        return (of.cycle->stages[run.stage].*radial.value).value_or(0);
    };
    return {ExerciseText::tr("The radial feed of stage %1 is halved, from %2 to %3.")
                .arg(QString::number(run.stage + 1), printedNumber(feedOf(project)),
                     withUnit(printedNumber(feedOf(run.changed)),
                              tableOf<Stage>().find(radial.key)->unit)),
            {{Asked::spread_um, false,
              ExerciseText::tr("the force at the end is that of a smaller feed, so the "
                               "deflections differ less from place to place")},
             {Asked::runout_um, false,
              project.operation->travels
                  ? ExerciseText::tr("less of it remains after more and shallower cuts")
                  : ExerciseText::tr("the last revolution leaves a step as deep as its "
                                     "cut, which is shallower now")}}};
}

ChangeWords rounder(const Project& project, const ExerciseRun&) {
    const double runout = project.part->initial_runout_mm;
    return {ExerciseText::tr("The blanks come with twice the runout, %1 instead of %2.")
                .arg(mm(runout * moreRunoutBy), mm(runout)),
            {{Asked::runout_um, true,
              ExerciseText::tr("high places are cut deeper than low ones, but not deep enough to "
                               "remove all of the added %1")
                  .arg(mm(runout * (moreRunoutBy - 1)))},
             {Asked::count, true,
              ExerciseText::tr("the stock is the minimum over all radii, so a larger runout means "
                               "more metal to remove")}}};
}

ChangeWords thicker(const Project& project, const ExerciseRun& run) {
    return {ExerciseText::tr("The stock is larger by a fifth: %1 instead of %2 per side, and the "
                             "first stage removes the rest.")
                .arg(mm(std::round(run.changed.part->stock_mm * digitsKept) / digitsKept),
                     mm(project.part->stock_mm)),
            {{Asked::count, true, ExerciseText::tr("the first stage has more metal to remove")}}};
}

ChangeWords wordsOf(const Project& project, const ExerciseRun& run) {
    switch (run.change) {
    case ExerciseChange::dullerWheel: return duller(project, run);
    case ExerciseChange::softerSystem: return softer(project, run);
    case ExerciseChange::slowerFeed: return slower(project, run);
    case ExerciseChange::moreRunout: return rounder(project, run);
    case ExerciseChange::thickerStock: return thicker(project, run);
    }
    return {};
}

/// The double stroke, if it is not that of the step.
QString asksAt(const Place& at, const Place& wanted, const Outcome& outcome) {
    if (at.cycleCount == wanted.cycleCount) {
        return ExerciseText::tr("The step is at the place and the radius worked out above.");
    }
    return (outcome.result.project.operation->travels
                ? ExerciseText::tr("The step is at the place and the radius worked out above; take "
                                   "double stroke %1, which both cycles have.")
                : ExerciseText::tr("The step is at the place and the radius worked out above; take "
                                   "revolution %1, which both cycles have."))
        .arg(at.cycleCount);
}

/// "Find how these change, and why: …" for the readable values.
QString asks(const std::vector<ExerciseAnswer>& answers, Operation operation) {
    QStringList names;
    for (const ExerciseAnswer& answer : answers) {
        names << Names::inSentence(askedQuantity(answer.asked, operation));
    }
    return (names.size() == 1 ? ExerciseText::tr("Find how this changes, and why: %1.")
                              : ExerciseText::tr("Find how these change, and why: %1."))
        .arg(names.join(QStringLiteral("; ")));
}

/// The parts of the time: stage by stage, and the effect of a longer lag.
QString whyTime(const std::vector<double>& was_s, const std::vector<double>& is_s, bool moreLag) {
    QStringList stages;
    bool firstLonger = false, laterShorter = false;
    for (std::size_t z = 0; z < std::min(was_s.size(), is_s.size()); ++z) {
        const double more_min = (is_s[z] - was_s[z]) / units::secondsPerMinute;
        if (std::abs(more_min) < leastTime_min) {
            continue;
        }
        firstLonger = firstLonger || (z == 0 && more_min > 0);
        laterShorter = laterShorter || (z > 0 && more_min < 0);
        const QString amount = Names::timeOfMinutes(std::abs(more_min));
        stages << (more_min > 0 ? ExerciseText::tr("stage %1 takes %2 longer")
                                : ExerciseText::tr("stage %1 takes %2 less"))
                      .arg(QString::number(z + 1), amount);
    }
    QStringList text{stages.join(QStringLiteral(", "))};
    if (moreLag && firstLonger) {
        text << ExerciseText::tr("the larger lag takes longer to build up");
    }
    if (moreLag && laterShorter) {
        text << ExerciseText::tr("the stored deflection continues to cut in the slower stage");
    }
    return text.join(QStringLiteral("; "));
}

/// The change of each answer, and its reason.
QString reasonOf(const ChangeWords& words, const ExerciseRun& run, const SimulationResult& was) {
    QStringList sentences;
    for (const ExerciseAnswer& answer : run.answers) {
        const bool rises = answer.after > answer.before;
        const auto known = std::ranges::find_if(words.why, [&](const Why& why) {
            return why.asked == answer.asked && why.rises == rises;
        });
        const QString why = answer.asked == Asked::time_min
                                ? whyTime(was.timeByStage_s, run.timeByStage_s, words.moreLag)
                            : known != words.why.end() ? known->text
                                                       : QString();
        const QString moved = movedText(answer.asked, was.project.operation, rises);
        sentences << (why.isEmpty() ? moved : moved + QStringLiteral(": ") + why) + u'.';
    }
    return sentences.join(u' ');
}

QString questionOf(const ChangeWords& words, const ExerciseRun& run, const Outcome& outcome,
                   const std::optional<RecordedStep>& step) {
    const QString question =
        words.statement + u' ' + asks(run.answers, outcome.result.project.operation);
    const bool ofStep = std::ranges::any_of(run.answers, [](const ExerciseAnswer& answer) {
        return answer.asked == Asked::stepFeed_um || answer.asked == Asked::stepForce_n;
    });
    return ofStep ? question + u' '
                        + asksAt(*run.at, outcome.trajectory.passes[step->pass].place, outcome)
                  : question;
}

struct ExerciseSheet {
    Q_DECLARE_TR_FUNCTIONS(ExerciseSheet)
};

constexpr int percent = 100;

/// The change in per cent, as far as the printed numbers determine it.
QString change(const ExerciseAnswer& answer) {
    const QString before = askedNumber(answer.asked, answer.before);
    if (before == askedNumber(answer.asked, answer.after)) {
        return QStringLiteral("0");
    }
    if (before == askedNumber(answer.asked, 0)) {
        return QStringLiteral("–");
    }
    const double percents = percent * (answer.after - answer.before) / std::abs(answer.before);
    return (percents > 0 ? QStringLiteral("+") : QString())
           + Names::significant(percents).replace(u'-', QChar(0x2212));
}

} // namespace

QString askedQuantity(Asked asked, Operation operation) {
    switch (asked) {
    case Asked::stepFeed_um: return ExerciseText::tr("Actual feed a of the step");
    case Asked::stepForce_n: return ExerciseText::tr("Normal force Py of the step");
    case Asked::time_min: return ExerciseText::tr("Machining time");
    case Asked::count:
        return operation->travels ? ExerciseText::tr("Number of double strokes")
                                  : ExerciseText::tr("Number of revolutions");
    case Asked::spread_um: return ExerciseText::tr("Maximum minus minimum diameter along the part");
    case Asked::runout_um: return ExerciseText::tr("Maximum radial runout");
    case Asked::peakForce_n: return ExerciseText::tr("Maximum normal force Py");
    case Asked::peakPower_kw: return ExerciseText::tr("Maximum power");
    }
    return {};
}

QString askedName(Asked asked, Operation operation) {
    const QString name = askedQuantity(asked, operation);
    const char* unit = unitOf(asked);
    return *unit ? name + QStringLiteral(", ") + unitText(unit) : name;
}

QString movedText(Asked asked, Operation operation, bool rises) {
    return (rises ? ExerciseText::tr("%1 rises") : ExerciseText::tr("%1 falls"))
        .arg(askedQuantity(asked, operation));
}

QString askedNumber(Asked asked, double value) {
    switch (asked) {
    case Asked::count: return QString::number(static_cast<int>(value));
    case Asked::time_min: return Names::timeOfMinutes(value, 4);
    case Asked::spread_um:
    case Asked::runout_um: return Names::micrometres(value);
    default: return Names::significant(value, 4);
    }
}

std::vector<Exercise> makeExercises(const Outcome& outcome, const std::optional<RecordedStep>& step,
                                    const std::function<void()>& breathe) {
    std::vector<Exercise> exercises;
    for (ExerciseRun& run : runExercises(outcome, step, breathe)) {
        const ChangeWords words = wordsOf(outcome.result.project, run);
        Exercise exercise;
        exercise.question = questionOf(words, run, outcome, step);
        exercise.reason = reasonOf(words, run, outcome.result);
        static_cast<ExerciseRun&>(exercise) = std::move(run);
        exercises.push_back(std::move(exercise));
    }
    return exercises;
}

std::vector<Block> exerciseQuestions(const std::vector<Exercise>& exercises) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        blocks.emplace_back(
            Paragraph{QStringLiteral("%1. %2").arg(QString::number(i + 1), exercises[i].question)});
    }
    return blocks;
}

std::vector<Block> exerciseAnswers(const std::vector<Exercise>& exercises, Operation operation) {
    std::vector<Block> blocks;
    blocks.emplace_back(Paragraph{ExerciseSheet::tr(
        "Computed by the engine, which ran the whole cycle with only that input changed.")});
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const Exercise& exercise = exercises[i];
        blocks.emplace_back(
            Paragraph{QStringLiteral("%1. %2").arg(QString::number(i + 1), exercise.reason)});
        Table table;
        table.head = {ExerciseSheet::tr("Asked for"), ExerciseSheet::tr("Before"),
                      ExerciseSheet::tr("Changed"), ExerciseSheet::tr("Difference, %")};
        table.texts = {true};
        for (const ExerciseAnswer& answer : exercise.answers) {
            table.rows.push_back({askedName(answer.asked, operation),
                                  askedNumber(answer.asked, answer.before),
                                  askedNumber(answer.asked, answer.after), change(answer)});
        }
        blocks.emplace_back(table);
    }
    return blocks;
}

} // namespace sparkout::report
