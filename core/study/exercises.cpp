// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/exercises.h"

#include "core/process/force.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/ranges.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

/// Whether two places differ only in the double stroke or revolution of the cycle.
bool alike(const Place& a, const Place& b) {
    return a.zone == b.zone && a.step == b.step && a.section == b.section && a.stage == b.stage
           && a.revolution == b.revolution;
}

// Least readable changes: for any quantity a share of its value, for a form the resolution of a
// gauge, for a count more than chance by the gauge's phase.
constexpr double readShare = 0.02;
constexpr double leastForm_um = 0.1;
constexpr double leastCount = 2;

/// A change of one input; empty if it is not possible.
struct Change {
    ExerciseRun run;
    std::vector<Asked> asked;
};
using MadeChange = std::optional<Change>;

Change changeOf(const Project& project, ExerciseChange kind, std::vector<Asked> asked) {
    return {{.change = kind, .changed = project}, std::move(asked)};
}

MadeChange duller(const Project& project) {
    Change change = changeOf(project, ExerciseChange::dullerWheel,
                             {Asked::stepFeed_um, Asked::stepForce_n, Asked::time_min});
    setDullness(*change.run.changed.wheel, dullnessOf(*project.wheel) * dullerBy);
    // With a threshold, the dullness does not enter the force.
    return dullnessOf(*project.wheel) > 0 && !hasThreshold(project) ? MadeChange(change)
                                                                    : std::nullopt;
}

MadeChange softer(const Project& project) {
    Change change = changeOf(project, ExerciseChange::softerSystem,
                             {Asked::spread_um, Asked::peakForce_n, Asked::time_min});
    Machine& machine = *change.run.changed.machine;
    if (auto* zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        for (double* value : {&zones->rz1, &zones->nz, &zones->rz2}) {
            *value *= softerBy;
        }
    } else if (auto* all = std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        std::ranges::for_each(*all, [](double& value) { value *= softerBy; });
    } else if (machine.stiffness_n_um) {
        for (double* value :
             {&machine.stiffness_n_um->headstock, &machine.stiffness_n_um->tailstock,
              &machine.stiffness_n_um->wheel_head}) {
            *value /= softerBy;
        }
    } else {
        return {};
    }
    return change;
}

MadeChange slower(const Project& project) {
    Change change = changeOf(project, ExerciseChange::slowerFeed,
                             {Asked::time_min, Asked::spread_um, Asked::runout_um});
    auto& stages = change.run.changed.cycle->stages;
    for (std::size_t z = stages.size(); z-- > 0;) {
        auto& feed = stages[z].*project.operation->radial().value;
        if (stages[z].feeds() && feed && *feed > 0) {
            const double before = *feed;
            feed = before * slowerBy;
            change.run.stage = z;
            return change;
        }
    }
    return {};
}

MadeChange rounder(const Project& project) {
    Change change = changeOf(project, ExerciseChange::moreRunout,
                             {Asked::runout_um, Asked::count, Asked::time_min});
    change.run.changed.part->initial_runout_mm *= moreRunoutBy;
    return project.part->initial_runout_mm > 0 && project.part->profile != ProfileForm::measured
               ? MadeChange(change)
               : std::nullopt;
}

MadeChange thicker(const Project& project) {
    Change change = changeOf(project, ExerciseChange::thickerStock,
                             {Asked::time_min, Asked::count, Asked::peakPower_kw});
    Project& changed = change.run.changed;
    const double more = project.part->stock_mm * (thickerBy - 1);
    if (changed.cycle->stages.empty() || !changed.cycle->stages.front().feeds()) {
        return {};
    }
    changed.part->stock_mm += more;
    changed.cycle->stages.front().stock_mm += more;
    return change;
}

/// Runs the changed project and reads the requested quantities of both; empty if there is nothing
/// to read.
std::optional<ExerciseRun> solved(Change change, const Outcome& outcome,
                                  const std::optional<RecordedStep>& step) {
    ExerciseRun& run = change.run;
    const bool needsStep = step && std::ranges::count(change.asked, Asked::stepFeed_um) > 0;
    Trajectory trajectory;
    SimulationResult result = simulate(run.changed, needsStep ? &trajectory : nullptr, {});
    if (result.status != RunStatus::completed) {
        return {}; // the cycle was interrupted
    }
    const Visit *before = nullptr, *after = nullptr;
    if (needsStep) {
        run.at = sharedPlace(outcome.trajectory, trajectory,
                             outcome.trajectory.passes[step->pass].place);
        if (run.at) {
            before = visitAt(outcome.trajectory, *run.at, step->radius);
            after = visitAt(trajectory, *run.at, step->radius);
        }
    }
    for (const Asked asked : change.asked) {
        const auto was = askedValue(asked, outcome.result, before);
        const auto is = askedValue(asked, result, after);
        if (was && is && canBeRead({asked, *was, *is})) {
            run.answers.push_back({asked, *was, *is});
        }
    }
    if (run.answers.empty()) {
        return {};
    }
    run.timeByStage_s = std::move(result.timeByStage_s);
    return std::move(run);
}

} // namespace

const Visit* visitAt(const Trajectory& trajectory, const RecordedStep& step) {
    return &trajectory.visits[trajectory.passes[step.pass].firstVisit
                              + static_cast<std::size_t>(step.radius)];
}

const Visit* visitAt(const Trajectory& trajectory, const Place& place, int radius) {
    for (std::size_t i = 0; i < trajectory.passes.size() && radius < trajectory.radii; ++i) {
        const Place& at = trajectory.passes[i].place;
        if (alike(at, place) && at.cycleCount == place.cycleCount) {
            return visitAt(trajectory, {i, radius});
        }
    }
    return nullptr;
}

std::optional<Place> sharedPlace(const Trajectory& one, const Trajectory& other,
                                 const Place& place) {
    std::set<int> counts;
    for (const Pass& pass : one.passes) {
        if (alike(pass.place, place)) {
            counts.insert(pass.place.cycleCount);
        }
    }
    std::optional<Place> nearest;
    for (const Pass& pass : other.passes) {
        const int count = pass.place.cycleCount;
        if (alike(pass.place, place) && counts.contains(count)
            && (!nearest
                || std::abs(count - place.cycleCount)
                       < std::abs(nearest->cycleCount - place.cycleCount))) {
            nearest = pass.place;
        }
    }
    return nearest;
}

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
        return surface.um(most.diameterDeviationMax_mm - least.diameterDeviationMin_mm);
    }
    case Asked::runout_um:
        return surface.um(
            std::ranges::max(result.sections, {}, &SectionResult::radialRunout_mm).radialRunout_mm);
    case Asked::peakForce_n: return result.peakNormalForce_n;
    case Asked::peakPower_kw: return result.peakPower_w / units::wPerKw;
    }
    return {};
}

bool canBeRead(const ExerciseAnswer& answer) {
    const double moved = std::abs(answer.after - answer.before);
    const bool isForm = answer.asked == Asked::spread_um || answer.asked == Asked::runout_um;
    const double least = isForm ? leastForm_um : answer.asked == Asked::count ? leastCount : 0;
    return moved > 0 && moved >= least && moved >= readShare * std::abs(answer.before);
}

std::vector<ExerciseRun> runExercises(const Outcome& outcome,
                                      const std::optional<RecordedStep>& step,
                                      const std::function<void()>& breathe) {
    Project project = outcome.result.project;
    project.runs.clear();
    std::vector<ExerciseRun> exercises;
    if (outcome.result.status != RunStatus::completed) {
        return exercises;
    }
    for (const auto make : {duller, softer, slower, rounder, thicker}) {
        if (MadeChange change = make(project); change && exercises.size() < mostExercises
                                               && !hasErrors(validate(change->run.changed))) {
            breathe();
            if (auto exercise = solved(std::move(*change), outcome, step)) {
                exercises.push_back(std::move(*exercise));
            }
        }
    }
    return exercises;
}

} // namespace sparkout
