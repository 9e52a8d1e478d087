// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/cycle_runner.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/plunge.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {
constexpr double peakRounding = 1e-9;
} // namespace

PassCuts::PassCuts(const Project& project)
    : m_points(static_cast<std::size_t>(zoneSectionCount(project) > 0 ? zoneSectionCount(project)
                                                                      : placeCount(project)))
    , m_low_mm(project.part->lower_deviation_um / units::umPerMm)
    , m_high_mm(project.part->upper_deviation_um / units::umPerMm)
    , m_least_mm(m_low_mm - 2 * diameterSlack_mm)
    , m_most_mm(m_high_mm + 2 * diameterSlack_mm)
    , m_isBore(project.part->surface == Surface::internal) {
    for (const Requirement& row : requirementRows) {
        if (auto bound = row.passBound ? row.passBound(project) : std::nullopt) {
            bound->most *= 1 + peakRounding;
            m_bounds.emplace_back(row.kind, *bound);
            m_most.push_back(bound->most);
        }
    }
}

// Self-sharpening does not limit the depth of cut itself, so its share is unknown here.
void PassCuts::demandMargin(double least) {
    constexpr double lastBits = 1e-9;
    const double demanded = std::max(least - lastBits, 0.0);
    const double edge_mm = demanded * (m_high_mm - m_low_mm);
    m_least_mm = m_low_mm + edge_mm - 2 * diameterSlack_mm;
    m_most_mm = m_high_mm - edge_mm + 2 * diameterSlack_mm;
    for (std::size_t i = 0; i < m_bounds.size(); ++i) {
        const PassBound& bound = m_bounds[i].second;
        m_most[i] = bound.most * (bound.peak == PassBound::Peak::power_w ? 1 - demanded : 1);
    }
}

std::optional<ConstraintKind> PassCuts::broken(const Run& run, std::size_t stage) const {
    if (run.surelyBurned()) {
        return ConstraintKind::burn;
    }
    const StageSums& sums = run.sumsOf(stage);
    for (std::size_t i = 0; i < m_bounds.size(); ++i) {
        const auto& [kind, bound] = m_bounds[i];
        const bool depth = bound.peak == PassBound::Peak::depth_mm;
        if ((depth ? sums.depth_mm : sums.power_w).value > m_most[i]) {
            return kind;
        }
    }
    return std::nullopt;
}

std::optional<ConstraintKind> PassCuts::brokenAtEnd(const Run& run) const {
    for (std::size_t i = 0; i < m_points; ++i) {
        const auto [least, most] = run.diameterDeviations(run.firstCounted() + i);
        if (least < m_least_mm) {
            return ConstraintKind::diameterMin;
        }
        if (most > m_most_mm) {
            return ConstraintKind::diameterMax;
        }
    }
    return std::nullopt;
}

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
