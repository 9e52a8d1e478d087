// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/grid_search.h"

#include "core/batch/batch_check.h"
#include "core/grace_stop.h"
#include "core/optimisation/binding.h"
#include "core/project/cycle.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "core/study/refine_answer.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

const std::vector<Project>& scenariosAdded(const GridSearchReport& report) {
    static const std::vector<Project> none;
    return report.robust ? report.robust->added : report.interval ? report.interval->parts : none;
}

/// The limit, and what binds the best of the grid.
void aboutTheBest(GridSearchReport& report, const std::stop_token& stop) {
    const GraceStop grace(stop);
    report.limit = steplessLimitBounds(report.searched, grace.token());
    report.limit_s = report.limit.time_s;
    if (report.search.status == SearchStatus::stopped || isHeuristic(report.method)
        || report.marginWithin_us) { // no cycle at all is quicker than that
        report.search.bound_s = std::max(report.search.bound_s, report.limit_s);
    }
    if (report.search.best && report.marginWithin_us) {
        report.binding = leastMarginRequirements(withBest(report.searched, report.search),
                                                 report.robust.has_value(), grace.token());
    } else if (report.search.best) {
        report.binding = bindingRequirements(report.searched, *report.search.best,
                                             scenariosAdded(report), grace.token());
    }
}

RefineSummary refined(const GridSearchReport& report, const std::stop_token& stop) {
    std::optional<RobustTrail> robust;
    if (report.robust) {
        robust = {report.robust->added, report.robust->candidates};
    }
    return refineAnswer({.asked = report.searched,
                         .best = withBest(report.searched, report.search),
                         .cycle = report.search.cycle,
                         .robust = std::move(robust)},
                        stop);
}

GivenCycle givenCycle(const Project& project, const std::stop_token& stop) {
    GivenCycle given;
    const SimulationResult result = simulateUnchecked(project, nullptr, stop);
    given.isStopped = result.status == RunStatus::stopped;
    if (result.status == RunStatus::completed) {
        given.time_s = result.time_s;
        for (const ConstraintResult& each : worstByKind(evaluateConstraints(result))) {
            if (!each.holds) {
                given.fails.push_back(each.kind);
            }
        }
    }
    return given;
}

/// Whether the answer must hold for the project's batch.
bool asksForABatch(const Project& project) {
    return project.optimisation->scenarios != OptimisationScenarios::nominal;
}

/// What keeps it from being searched, before anything is.
GridSearchReport checked(const Project& project, const GridSearchOptions& options) {
    GridSearchReport report;
    report.project = project;
    report.method = options.method;
    report.issues = validate(project);
    if (!hasErrors(report.issues)) {
        report.issues.clear();
        report.isOtherOperation = isHeuristic(options.method) && project.operation->axial();
        report.marginWithin_us = marginWithinOf(project);
        report.isOtherAim =
            (report.marginWithin_us || objectiveOf(project) != SearchObjective::time)
            && (isHeuristic(options.method) || options.refine);
        report.objectiveFault = objectiveFault(project, options.robust);
        report.fault = Variants(project, options.stop).fault();
        if (report.ran() && asksForABatch(project)) {
            report.issues = checkBatch(project);
        }
    }
    return report;
}

/// One round of levels.
void searchOnce(GridSearchReport& report, const Project& searched, const GridSearchOptions& options,
                const SearchOptions& search) {
    report.searched = searched;
    if (objectiveOf(searched) != SearchObjective::time) {
        report.interval = searchInterval(searched, options.wear.value_or(SurfaceWear(searched)),
                                         {.search = search});
        report.search = report.interval->search;
    } else if (options.robust || asksForABatch(searched)) {
        report.robust = optimiseRobustly(searched, undecidedScenarios(searched, options.stop),
                                         {.search = search});
        report.search = report.robust->search;
    } else {
        report.search = optimise(searched, search);
    }
}

bool isDone(const GridSearchReport& report) {
    return hasAnswer(report) && report.search.status != SearchStatus::stopped;
}

} // namespace

GridSearchReport searchGrid(const Project& project, const GridSearchOptions& options) {
    GridSearchReport report = checked(project, options);
    if (!report.ran()) {
        return report;
    }
    SearchOptions search;
    search.method = options.method;
    search.threads = options.threads;
    search.onProgress = options.onProgress;
    search.journal = options.journal;
    search.stop = options.stop;
    search.marginWithin_us = report.marginWithin_us;
    SearchLevels levels(project);
    searchOnce(report, levels.searched(), options, search);
    while (isDone(report) && levels.goOn(report.search.cycle, *report.search.best)) {
        GridSearchReport finer = report;
        searchOnce(finer, levels.searched(), options, search);
        if (finer.search.status == SearchStatus::stopped) {
            report.areLevelsCutShort = true; // the answer of the round before stands
            break;
        }
        finer.rounds = levels.round();
        report = std::move(finer);
    }
    if (hasAnswer(report)) {
        report.edges = edgesReached(report.searched, report.search.cycle);
    }
    aboutTheBest(report, options.stop);
    if (options.refine && hasAnswer(report)) {
        report.refined = refined(report, options.stop);
    }
    const GraceStop grace(options.stop);
    report.given = givenCycle(project, grace.token());
    if (isRefined(report)) {
        report.binding =
            bindingRequirements(withBest(project, report.search), report.refined->cycle,
                                report.refined->time_us, scenariosAdded(report), grace.token());
    }
    return report;
}

bool isRefined(const GridSearchReport& report) {
    return report.refined && report.refined->isQuicker;
}

bool hasAnswer(const GridSearchReport& report) {
    return report.search.best && (!report.robust || report.robust->holdsInSample);
}

const Cycle& cycleFound(const GridSearchReport& report) {
    return isRefined(report) ? report.refined->cycle : report.search.cycle;
}

Project withAnswer(const GridSearchReport& report) {
    Project project = withBest(report.project, report.search);
    *project.cycle = cycleFound(report);
    return project;
}

} // namespace sparkout
