// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/exercises.h"

#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "core/units.h"
#include "ui/report/report_values.h"
#include "ui/views/names.h"

#include <QCoreApplication>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr double dulling = 2, softening = 1.5, slowing = 0.5, wobbling = 2, moreStock = 1.2;

struct ExerciseText {
    Q_DECLARE_TR_FUNCTIONS(Exercises)
};

/// A change of one input, told as a question; nothing where it cannot be made.
struct Change {
    Project project;
    std::vector<Asked> asked;
    QString told;
    QString reason;
};
using MadeChange = std::optional<Change>;

QString mm(double value) {
    return withUnit(plainNumber(value), "mm");
}

MadeChange duller(const Project& project) {
    Change change{project, {Asked::stepFeed_um, Asked::stepForce_n, Asked::time_min}, {}, {}};
    double& dullness = change.project.wheel.dullness;
    dullness *= dulling;
    change.told =
        ExerciseText::tr("The wheel has become dull: η rises from %1 to %2. How do the actual feed "
                         "a and the normal force Py change, at the same zone, step and radius as "
                         "above, and how the machining time?")
            .arg(plainNumber(project.wheel.dullness), plainNumber(dullness));
    change.reason =
        ExerciseText::tr("The friction of the wear flats, kr·√a, grows with η. At the "
                         "same lag less is cut, so the lag and the force grow until "
                         "the programmed feed is cut again. What the system has yielded "
                         "goes on cutting in the next, slower stage.");
    return project.wheel.dullness > 0 ? MadeChange(change) : std::nullopt;
}

/// Every compliance of the system, given or computed, by the same factor.
MadeChange softer(const Project& project) {
    Change change{project, {Asked::spread_um, Asked::peakForce_n, Asked::time_min}, {}, {}};
    change.told = ExerciseText::tr("The technological system is %1 times as compliant in every "
                                   "zone. How do the difference of diameters along the part and "
                                   "the largest normal force change?")
                      .arg(plainNumber(softening));
    change.reason = ExerciseText::tr("A zone differs in diameter from the one with the gauge "
                                     "by twice the difference of their deflections γ·Py at the "
                                     "end. The lag of a compliant system takes longer to build "
                                     "up, and goes on cutting when the feed is reduced.");
    Machine& machine = change.project.machine;
    if (auto* zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        for (double* value : {&zones->rz1, &zones->nz, &zones->rz2}) {
            *value *= softening;
        }
    } else if (auto* all = std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        std::ranges::for_each(*all, [](double& value) { value *= softening; });
    } else if (machine.stiffness_n_um) {
        change.told =
            ExerciseText::tr("The units of the machine yield %1 times as much under the same "
                             "force. How do the difference of diameters along the "
                             "part and the largest normal force change?")
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
    Change change{project, {Asked::time_min, Asked::spread_um, Asked::runout_um}, {}, {}};
    change.reason = ExerciseText::tr("A smaller feed ends the cycle with a smaller force, hence a "
                                     "smaller deflection that differs less from zone to zone; for "
                                     "the same stock it takes longer.");
    const bool traverse = project.operation == Operation::traverse;
    auto& stages = change.project.cycle.stages;
    for (std::size_t z = stages.size(); z-- > 0;) {
        auto& feed = traverse ? stages[z].radial_feed_mm : stages[z].radial_feed_mm_min;
        if (stages[z].spark_out.mode == SparkOut::Mode::none && feed && *feed > 0) {
            const double before = *feed;
            feed = before * slowing;
            const char* const unit = traverse ? "mm/dbl stroke" : "mm/min";
            change.told =
                ExerciseText::tr("The radial feed of stage %1 is halved, from %2 to %3. What does "
                                 "that cost in time, and what does it gain in accuracy?")
                    .arg(QString::number(z + 1), plainNumber(before),
                         withUnit(plainNumber(*feed), unit));
            return change;
        }
    }
    return {};
}

MadeChange rounder(const Project& project) {
    const double runout = project.part.initial_runout_mm;
    Change change{project, {Asked::runout_um, Asked::count, Asked::time_min}, {}, {}};
    change.told = ExerciseText::tr("The blanks come with twice the runout, %1 instead of %2. How "
                                   "much of it is left on the part, and what does it cost?")
                      .arg(mm(runout * wobbling), mm(runout));
    change.reason = ExerciseText::tr("The stock is the least that any radius has, so a larger "
                                     "runout is more metal to take off. High places are cut "
                                     "deeper than low ones: pass by pass little of the runout "
                                     "is left.");
    change.project.part.initial_runout_mm *= wobbling;
    return runout > 0 && project.part.profile != ProfileForm::measured ? MadeChange(change)
                                                                       : std::nullopt;
}

/// More metal for the first stage to take off.
MadeChange thicker(const Project& project) {
    Change change{project, {Asked::time_min, Asked::count, Asked::peakPower_kw}, {}, {}};
    change.reason = ExerciseText::tr("The first stage lasts longer. Force and power are those of "
                                     "its feeds: once the lag is built up, they no longer depend "
                                     "on how much is left. How far the gauge lets a stage overrun "
                                     "depends on the phase, and with it the time of the slow "
                                     "stage.");
    Project& changed = change.project;
    const double more = project.part.stock_mm * (moreStock - 1);
    if (changed.cycle.stages.empty()
        || changed.cycle.stages.front().spark_out.mode != SparkOut::Mode::none) {
        return {};
    }
    changed.part.stock_mm += more;
    changed.cycle.stages.front().stock_mm += more;
    change.told = ExerciseText::tr("The stock is larger by a fifth: %1 instead of %2 per side, and "
                                   "the first stage takes the rest off. How do the machining time "
                                   "and the largest power change?")
                      .arg(withUnit(Names::significant(changed.part.stock_mm), "mm"),
                           mm(project.part.stock_mm));
    return change;
}

/// In which double stroke, where it is not that of the step.
QString asksAt(const Place& at, const Place& wanted, const Outcome& outcome) {
    if (at.cycleCount == wanted.cycleCount) {
        return {};
    }
    return (outcome.result.project.operation == Operation::traverse
                ? ExerciseText::tr("Take double stroke %1, which both cycles have.")
                : ExerciseText::tr("Take revolution %1, which both cycles have."))
        .arg(at.cycleCount);
}

/// Runs the changed project and reads off both what is asked for.
Exercise solved(Change change, const Outcome& outcome, const std::optional<HandoutStep>& step) {
    Exercise exercise{change.told, change.reason, change.project};
    const bool needsStep = step && std::ranges::count(change.asked, Asked::stepFeed_um) > 0;
    Trajectory trajectory;
    const SimulationResult result =
        simulate(exercise.changed, needsStep ? &trajectory : nullptr, {});
    exercise.status = result.status;
    const Visit *before = nullptr, *after = nullptr;
    if (needsStep) {
        const Place& wanted = outcome.trajectory.passes[step->pass].place;
        exercise.at = sharedPlace(outcome.trajectory, trajectory, wanted);
        if (exercise.at) {
            before = visitAt(outcome.trajectory, *exercise.at, step->radius);
            after = visitAt(trajectory, *exercise.at, step->radius);
            exercise.question += u' ' + asksAt(*exercise.at, wanted, outcome);
        }
    }
    for (const Asked asked : change.asked) {
        const auto was = askedValue(asked, outcome.result, before);
        const auto is = askedValue(asked, result, after);
        if (was && is) {
            exercise.answers.push_back({asked, *was, *is});
        }
    }
    exercise.question = exercise.question.trimmed();
    return exercise;
}

} // namespace

std::optional<double> askedValue(Asked asked, const SimulationResult& result, const Visit* visit) {
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
        return (most.diameterDeviationMax_mm - least.diameterDeviationMin_mm) * units::umPerMm;
    }
    case Asked::runout_um:
        return std::ranges::max(result.sections, {}, &SectionResult::radialRunout_mm)
                   .radialRunout_mm
               * units::umPerMm;
    case Asked::peakForce_n: return result.peakNormalForce_n;
    case Asked::peakPower_kw: return result.peakPower_w / units::wPerKw;
    }
    return {};
}

QString askedName(Asked asked, Operation operation) {
    switch (asked) {
    case Asked::stepFeed_um: return ExerciseText::tr("Actual feed a of the step, µm");
    case Asked::stepForce_n: return ExerciseText::tr("Normal force Py of the step, N");
    case Asked::time_min: return ExerciseText::tr("Machining time, min");
    case Asked::count:
        return operation == Operation::traverse ? ExerciseText::tr("Double strokes")
                                                : ExerciseText::tr("Revolutions");
    case Asked::spread_um:
        return ExerciseText::tr("Largest less smallest diameter along the part, µm");
    case Asked::runout_um: return ExerciseText::tr("Largest radial runout, µm");
    case Asked::peakForce_n: return ExerciseText::tr("Largest normal force Py, N");
    case Asked::peakPower_kw: return ExerciseText::tr("Largest power, kW");
    }
    return {};
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
    for (const auto make : {duller, softer, slower, rounder, thicker}) {
        if (MadeChange change = make(project);
            change && exercises.size() < mostExercises && !hasErrors(validate(change->project))) {
            breathe();
            exercises.push_back(solved(std::move(*change), outcome, step));
        }
    }
    return exercises;
}

} // namespace sparkout::report
