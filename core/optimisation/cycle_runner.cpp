// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/cycle_runner.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/simulation/plunge.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

std::int64_t comparedTime_us(double time_s) {
    return std::llround(time_s * 1e6);
}

StepFeed stepFeedOf(const Project& project, const StageSetting& setting, std::size_t stage) {
    return {.infeed_mm =
                project.operation.infeed_mm(setting.radial, project.machine->work_speed_rpm),
            .stage = stage,
            .axialFeed_mm_min = setting.axialFeed_mm_min,
            .continuousFeed_mm_min = setting.continuousFeed_mm_min};
}

void SearchCounts::add(const SearchCounts& other) {
    evaluations += other.evaluations;
    visits += other.visits;
    for (std::size_t kind = 0; kind < cuts.size(); ++kind) {
        cuts[kind] += other.cuts[kind];
    }
}

CycleRunner::CycleRunner(const Project& project, const Grid& grid, const std::stop_token& stop)
    : m_grid(&grid), m_cuts(project), m_gauged(project.gauge->control == Control::gauge) {
    for (const std::size_t stages : grid.stageCounts()) {
        m_starts.resize(std::max(m_starts.size(), stages + 1));
        Start& start = m_starts[stages];
        start.project = std::make_unique<Project>(project);
        start.project->runs.clear();
        start.project->cycle->stages.assign(stages, {});
        start.steps = project.operation.match(
            [&](Traverse) { return traverseSteps(*start.project, Zone::nz, nullptr, stop); },
            [&](Plunge) { return plungeSteps(*start.project, nullptr, stop); });
    }
}

std::shared_ptr<const CycleSteps> CycleRunner::begin(std::size_t stages) const {
    return m_starts[stages].steps;
}

SimulationResult CycleRunner::finish(const GridCycle& cycle, CycleSteps& steps,
                                     const std::vector<int>& stepsByStage) {
    *m_starts[cycle.size()].project->cycle = m_grid->cycle(cycle);
    return steps.finish(stepsByStage);
}

// Cycles of a grid neither spark out nor retract: none of their stages waits.
std::optional<SimulationResult> CycleRunner::run(const GridCycle& cycle, std::int64_t slowest_us,
                                                 SearchCounts& counts) {
    Project& project = *m_starts[cycle.size()].project;
    *project.cycle = m_grid->cycle(cycle);
    const std::unique_ptr<CycleSteps> steps = begin(cycle.size())->copy();
    Run& run = steps->run();
    StageControl control(project, infeedsOfStages(project), run.blank().totalInfeed_mm);
    while (!control.finished() && !run.mustEnd()) {
        const std::size_t stage = control.stage();
        StepFeed feed = stepFeedOf(project, m_grid->settings()[cycle[stage].setting], stage);
        feed.infeed_mm = control.nextInfeed(run.fed_mm);
        feed.most_mm = control.mostFed();
        if (!steps->step(feed)) {
            break;
        }
        control.stepDone(steps->remaining(), run.fed_mm, run.time_s());
        const auto broken = m_cuts.broken(run, stage);
        if (broken) {
            ++counts.cuts[static_cast<std::size_t>(*broken)];
        }
        if (broken || comparedTime_us(run.time_s()) > slowest_us) {
            counts.visits += run.visits();
            return std::nullopt;
        }
    }
    counts.visits += run.visits();
    if (const auto broken = m_cuts.brokenAtEnd(run); broken && control.finished()) {
        ++counts.cuts[static_cast<std::size_t>(*broken)];
        return std::nullopt;
    }
    return steps->finish(control.stepsByStage());
}

} // namespace sparkout
