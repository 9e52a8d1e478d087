// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/exercises.h"

#include "core/project/validate.h"
#include "core/quality/finished_surface.h"
#include "core/simulation/simulate.h"
#include "core/units.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr double dulling = 2, softening = 1.5, slowing = 0.5, wobbling = 2, moreStock = 1.2;
constexpr double digitsKept = 1e6;

// What can be read: of any quantity so much of its value, of a form so much as a gauge shows, of a
// count more than the phase of the gauge makes by chance.
constexpr double leastShare = 0.02;
constexpr double leastForm_um = 0.1;
constexpr double leastCount = 2;
constexpr double leastTime_min = 5e-4; ///< of a stage

struct ExerciseText {
    Q_DECLARE_TR_FUNCTIONS(Exercises)
};

/// Why an answer moves in this direction; said only where it does.
struct Why {
    Asked asked;
    bool rises;
    QString text;
};

/// A change of one input; nothing where it cannot be made.
struct Change {
    Project project;
    std::vector<Asked> asked;
    QString told;
    std::vector<Why> why{};
    bool moreLag = false; ///< the system lags further behind its feed
};
using MadeChange = std::optional<Change>;

const char* unitOf(Asked asked) {
    switch (asked) {
    case Asked::stepFeed_um:
    case Asked::spread_um:
    case Asked::runout_um: return "µm";
    case Asked::stepForce_n:
    case Asked::peakForce_n: return "N";
    case Asked::time_min: return "min";
    case Asked::peakPower_kw: return "kW";
    case Asked::count: break;
    }
    return "";
}

QString mm(double value) {
    return withUnit(plainNumber(value), "mm");
}

MadeChange duller(const Project& project) {
    Change change{project, {Asked::stepFeed_um, Asked::stepForce_n, Asked::time_min}, {}};
    double& dullness = change.project.wheel.dullness;
    dullness *= dulling;
    change.told = ExerciseText::tr("The wheel has become dull: η rises from %1 to %2.")
                      .arg(plainNumber(project.wheel.dullness), plainNumber(dullness));
    change.why = {{Asked::stepFeed_um, false, ExerciseText::tr("at the same lag less is cut")},
                  {Asked::stepForce_n, true,
                   ExerciseText::tr("the friction of the wear flats, kr·√a, grows with η")}};
    change.moreLag = true;
    return project.wheel.dullness > 0 ? MadeChange(change) : std::nullopt;
}

/// Every compliance of the system, given or computed, by the same factor.
MadeChange softer(const Project& project) {
    Change change{project, {Asked::spread_um, Asked::peakForce_n, Asked::time_min}, {}};
    change.told =
        (project.operation->hasZones
             ? ExerciseText::tr("The technological system is %1 times as compliant in every zone.")
             : ExerciseText::tr("The technological system is %1 times as compliant in every "
                                "section."))
            .arg(plainNumber(softening));
    change.why = {{Asked::spread_um, true,
                   ExerciseText::tr("a place differs in diameter from the one with the gauge by "
                                    "twice the difference of their deflections γ·Py at the end")},
                  {Asked::peakForce_n, false,
                   ExerciseText::tr("the lag takes longer to build up, and the stage is over "
                                    "before the force of its feed is reached")}};
    change.moreLag = true;
    Machine& machine = change.project.machine;
    if (auto* zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        for (double* value : {&zones->rz1, &zones->nz, &zones->rz2}) {
            *value *= softening;
        }
    } else if (auto* all = std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        std::ranges::for_each(*all, [](double& value) { value *= softening; });
    } else if (machine.stiffness_n_um) {
        change.told = ExerciseText::tr(
                          "The units of the machine yield %1 times as much under the same force.")
                          .arg(plainNumber(softening));
        for (double* value :
             {&machine.stiffness_n_um->headstock, &machine.stiffness_n_um->tailstock,
              &machine.stiffness_n_um->wheel_head}) {
            *value /= softening;
        }
    } else {
        return {};
    }
    return change;
}

/// The last stage that feeds, at half its feed.
MadeChange slower(const Project& project) {
    Change change{project, {Asked::time_min, Asked::spread_um, Asked::runout_um}, {}};
    const bool strokes = project.operation->countsStrokes;
    const StageFeed& radial = project.operation->radial();
    change.why = {{Asked::spread_um, false,
                   ExerciseText::tr("the force at the end is that of a smaller feed, so the "
                                    "deflections differ less from place to place")},
                  {Asked::runout_um, false,
                   strokes ? ExerciseText::tr("after more and shallower cuts less of it is left")
                           : ExerciseText::tr("the last revolution leaves a step as deep as its "
                                              "cut, which is shallower now")}};
    auto& stages = change.project.cycle.stages;
    for (std::size_t z = stages.size(); z-- > 0;) {
        auto& feed = stages[z].*radial.value;
        if (stages[z].feeds() && feed && *feed > 0) {
            const double before = *feed;
            feed = before * slowing;
            const char* const unit = tableOf<Stage>().find(radial.key)->unit;
            change.told = ExerciseText::tr("The radial feed of stage %1 is halved, from %2 to %3.")
                              .arg(QString::number(z + 1), plainNumber(before),
                                   withUnit(plainNumber(*feed), unit));
            return change;
        }
    }
    return {};
}

MadeChange rounder(const Project& project) {
    const double runout = project.part.initial_runout_mm;
    Change change{project, {Asked::runout_um, Asked::count, Asked::time_min}, {}};
    change.told = ExerciseText::tr("The blanks come with twice the runout, %1 instead of %2.")
                      .arg(mm(runout * wobbling), mm(runout));
    change.why = {{Asked::runout_um, true,
                   ExerciseText::tr("high places are cut deeper than low ones, but not so much "
                                    "deeper that nothing is left of the added %1")
                       .arg(mm(runout * (wobbling - 1)))},
                  {Asked::count, true,
                   ExerciseText::tr("the stock is the least that any radius has, so a larger "
                                    "runout is more metal to take off")}};
    change.project.part.initial_runout_mm *= wobbling;
    return runout > 0 && project.part.profile != ProfileForm::measured ? MadeChange(change)
                                                                       : std::nullopt;
}

/// More metal for the first stage to take off.
MadeChange thicker(const Project& project) {
    Change change{project, {Asked::time_min, Asked::count, Asked::peakPower_kw}, {}};
    change.why = {
        {Asked::count, true, ExerciseText::tr("the first stage has more metal to take off")}};
    Project& changed = change.project;
    const double more = project.part.stock_mm * (moreStock - 1);
    if (changed.cycle.stages.empty() || !changed.cycle.stages.front().feeds()) {
        return {};
    }
    changed.part.stock_mm += more;
    changed.cycle.stages.front().stock_mm += more;
    change.told =
        ExerciseText::tr("The stock is larger by a fifth: %1 instead of %2 per side, and the first "
                         "stage takes the rest off.")
            .arg(mm(std::round(changed.part.stock_mm * digitsKept) / digitsKept),
                 mm(project.part.stock_mm));
    return change;
}

/// In which double stroke, where it is not that of the step.
QString asksAt(const Place& at, const Place& wanted, const Outcome& outcome) {
    if (at.cycleCount == wanted.cycleCount) {
        return ExerciseText::tr("The step is at the place and the radius worked out above.");
    }
    return (outcome.result.project.operation->countsStrokes
                ? ExerciseText::tr("The step is at the place and the radius worked out above; take "
                                   "double stroke %1, which both cycles have.")
                : ExerciseText::tr("The step is at the place and the radius worked out above; take "
                                   "revolution %1, which both cycles have."))
        .arg(at.cycleCount);
}

/// "Find how these change, and why: …" for what can be read.
QString asks(const std::vector<Answer>& answers, Operation operation) {
    QStringList names;
    for (const Answer& answer : answers) {
        names << Names::inSentence(askedQuantity(answer.asked, operation));
    }
    return (names.size() == 1 ? ExerciseText::tr("Find how this changes, and why: %1.")
                              : ExerciseText::tr("Find how these change, and why: %1."))
        .arg(names.join(QStringLiteral("; ")));
}

/// Where the time goes: stage by stage, and what a longer lag does to it.
QString whyTime(const SimulationResult& was, const SimulationResult& is, bool moreLag) {
    QStringList stages;
    bool firstLonger = false, laterShorter = false;
    const std::size_t count = std::min(was.timeByStage_s.size(), is.timeByStage_s.size());
    for (std::size_t z = 0; z < count; ++z) {
        const double more_min =
            (is.timeByStage_s[z] - was.timeByStage_s[z]) / units::secondsPerMinute;
        if (std::abs(more_min) < leastTime_min) {
            continue;
        }
        firstLonger = firstLonger || (z == 0 && more_min > 0);
        laterShorter = laterShorter || (z > 0 && more_min < 0);
        const QString amount = withUnit(Names::significant(std::abs(more_min)), "min");
        stages << (more_min > 0 ? ExerciseText::tr("stage %1 takes %2 longer")
                                : ExerciseText::tr("stage %1 takes %2 less"))
                      .arg(QString::number(z + 1), amount);
    }
    QStringList text{stages.join(QStringLiteral(", "))};
    if (moreLag && firstLonger) {
        text << ExerciseText::tr("the larger lag takes longer to build up");
    }
    if (moreLag && laterShorter) {
        text << ExerciseText::tr("what the system has yielded goes on cutting in the slower stage");
    }
    return text.join(QStringLiteral("; "));
}

/// How each answer moves, and why.
QString reasonOf(const Change& change, const std::vector<Answer>& answers,
                 const SimulationResult& was, const SimulationResult& is) {
    QStringList sentences;
    for (const Answer& answer : answers) {
        const bool rises = answer.after > answer.before;
        const auto known = std::ranges::find_if(change.why, [&](const Why& why) {
            return why.asked == answer.asked && why.rises == rises;
        });
        const QString why = answer.asked == Asked::time_min ? whyTime(was, is, change.moreLag)
                            : known != change.why.end()     ? known->text
                                                            : QString();
        const QString moved = movedText(answer.asked, was.project.operation, rises);
        sentences << (why.isEmpty() ? moved : moved + QStringLiteral(": ") + why) + u'.';
    }
    return sentences.join(u' ');
}

/// Runs the changed project and reads off both what is asked for; nothing where there is nothing
/// to read.
std::optional<Exercise> solved(const Change& change, const Outcome& outcome,
                               const std::optional<HandoutStep>& step) {
    Exercise exercise{{}, {}, change.project};
    const bool needsStep = step && std::ranges::count(change.asked, Asked::stepFeed_um) > 0;
    Trajectory trajectory;
    const SimulationResult result =
        simulate(exercise.changed, needsStep ? &trajectory : nullptr, {});
    if (result.status != RunStatus::completed) {
        return {}; // its numbers are of a cycle that was broken off
    }
    const Visit *before = nullptr, *after = nullptr;
    if (needsStep) {
        exercise.at = sharedPlace(outcome.trajectory, trajectory,
                                  outcome.trajectory.passes[step->pass].place);
        if (exercise.at) {
            before = visitAt(outcome.trajectory, *exercise.at, step->radius);
            after = visitAt(trajectory, *exercise.at, step->radius);
        }
    }
    bool ofStep = false;
    for (const Asked asked : change.asked) {
        const auto was = askedValue(asked, outcome.result, before);
        const auto is = askedValue(asked, result, after);
        if (was && is && canBeRead({asked, *was, *is})) {
            exercise.answers.push_back({asked, *was, *is});
            ofStep = ofStep || asked == Asked::stepFeed_um || asked == Asked::stepForce_n;
        }
    }
    if (exercise.answers.empty()) {
        return {};
    }
    exercise.question =
        change.told + u' ' + asks(exercise.answers, outcome.result.project.operation);
    if (ofStep) {
        exercise.question +=
            u' ' + asksAt(*exercise.at, outcome.trajectory.passes[step->pass].place, outcome);
    }
    exercise.reason = reasonOf(change, exercise.answers, outcome.result, result);
    return exercise;
}

} // namespace

std::optional<double> askedValue(Asked asked, const SimulationResult& result, const Visit* visit) {
    const FinishedSurface surface(result.project);
    switch (asked) {
    case Asked::stepFeed_um:
        return visit ? std::optional(visit->actual_mm * units::umPerMm) : std::nullopt;
    case Asked::stepForce_n: return visit ? std::optional(visit->normalForce_n) : std::nullopt;
    case Asked::time_min: return result.time_s / units::secondsPerMinute;
    case Asked::count: return result.cycleCount;
    case Asked::spread_um: {
        const auto& sections = result.sections;
        const auto least = std::ranges::min(sections, {}, &SectionResult::diameterDeviationMin_mm);
        const auto most = std::ranges::max(sections, {}, &SectionResult::diameterDeviationMax_mm);
        return surface.stated((most.diameterDeviationMax_mm - least.diameterDeviationMin_mm)
                              * units::umPerMm);
    }
    case Asked::runout_um:
        return surface.stated(
            std::ranges::max(result.sections, {}, &SectionResult::radialRunout_mm).radialRunout_mm
            * units::umPerMm);
    case Asked::peakForce_n: return result.peakNormalForce_n;
    case Asked::peakPower_kw: return result.peakPower_w / units::wPerKw;
    }
    return {};
}

QString askedQuantity(Asked asked, Operation operation) {
    switch (asked) {
    case Asked::stepFeed_um: return ExerciseText::tr("Actual feed a of the step");
    case Asked::stepForce_n: return ExerciseText::tr("Normal force Py of the step");
    case Asked::time_min: return ExerciseText::tr("Machining time");
    case Asked::count:
        return operation->countsStrokes ? ExerciseText::tr("Number of double strokes")
                                        : ExerciseText::tr("Number of revolutions");
    case Asked::spread_um: return ExerciseText::tr("Largest less smallest diameter along the part");
    case Asked::runout_um: return ExerciseText::tr("Largest radial runout");
    case Asked::peakForce_n: return ExerciseText::tr("Largest normal force Py");
    case Asked::peakPower_kw: return ExerciseText::tr("Largest power");
    }
    return {};
}

QString askedName(Asked asked, Operation operation) {
    const QString name = askedQuantity(asked, operation);
    const char* unit = unitOf(asked);
    return *unit ? name + QStringLiteral(", ") + unitText(unit) : name;
}

bool canBeRead(const Answer& answer) {
    const double moved = std::abs(answer.after - answer.before);
    const bool isForm = answer.asked == Asked::spread_um || answer.asked == Asked::runout_um;
    const double least = isForm ? leastForm_um : answer.asked == Asked::count ? leastCount : 0;
    return moved > 0 && moved >= least && moved >= leastShare * std::abs(answer.before);
}

QString movedText(Asked asked, Operation operation, bool rises) {
    return (rises ? ExerciseText::tr("%1 rises") : ExerciseText::tr("%1 falls"))
        .arg(askedQuantity(asked, operation));
}

QString askedNumber(Asked asked, double value) {
    switch (asked) {
    case Asked::count: return QString::number(static_cast<int>(value));
    case Asked::spread_um:
    case Asked::runout_um: return Names::micrometres(value);
    default: return Names::significant(value, 4);
    }
}

std::vector<Exercise> makeExercises(const Outcome& outcome, const std::optional<HandoutStep>& step,
                                    const std::function<void()>& breathe) {
    Project project = outcome.result.project;
    project.runs.clear();
    std::vector<Exercise> exercises;
    if (outcome.result.status != RunStatus::completed) {
        return exercises;
    }
    for (const auto make : {duller, softer, slower, rounder, thicker}) {
        if (MadeChange change = make(project);
            change && exercises.size() < mostExercises && !hasErrors(validate(change->project))) {
            breathe();
            if (auto exercise = solved(*change, outcome, step)) {
                exercises.push_back(std::move(*exercise));
            }
        }
    }
    return exercises;
}

} // namespace sparkout::report
