// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/stage_runs.h"

#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/simulation/stage_control.h"

#include <algorithm>
#include <utility>

namespace sparkout {

std::size_t prefixBytes(const Project& project) {
    constexpr std::size_t numbersPerLane = 12, rest = 4096;
    const int more = project.operation->travels ? zoneSectionCount(project) : 1; // a free gauge
    const int places = placeCount(project) + more;
    const auto lanes = static_cast<std::size_t>(places)
                       * static_cast<std::size_t>(project.part->radii_per_section);
    return lanes * numbersPerLane * sizeof(double) + rest;
}

void CyclePrefix::keep(std::shared_ptr<const CycleSteps> done) {
    recordState(*done);
    steps = std::move(done);
    since = 0;
}

void CyclePrefix::recordState(const CycleSteps& done) {
    time_s = done.run().time_s();
    fed_mm = done.run().fed_mm;
    if (isBeforeLast() && done.follower()) {
        critical = criticalRadii(done);
    }
}

StageRuns::StageRuns(const Project& project, const Grid& grid, const CycleRunner& runner,
                     Bounds bounds)
    : m_grid(grid)
    , m_cuts(runner.cuts())
    , m_part(runner.begin(grid.stageCounts().front()))
    , m_total(m_part->run().blank().totalInfeed_mm)
    , m_fedAtSize_mm(fedAtSize(project, m_total))
    , m_gauge(project.gauge->control == Control::gauge)
    , m_signal(project, grid.sparkOut() == 0) {
    for (const StageSetting& setting : grid.settings()) {
        m_steps.push_back(stepFeedOf(project, setting, 0));
    }
    if (const RadiusFollower* follower = m_gauge ? m_part->follower() : nullptr) {
        for (const StepFeed& step : m_steps) {
            m_feeds.push_back(follower->feed(step));
        }
    }
    if (bounds == Bounds::yes) {
        m_bound.emplace(project, grid, m_total);
        if (canBoundLastStage()) {
            m_lags.emplace(*m_part->follower(), m_feeds, m_part->gaugePoint());
        }
    }
}

int StageRuns::leastTaken(const CyclePrefix& prefix) const {
    return prefix.isBeforeLast()
               ? prefix.taken
               : m_grid.leastTaken(prefix.stages, prefix.cycle.size(), prefix.taken);
}

int StageRuns::mostTaken(const CyclePrefix& prefix) const {
    return m_grid.mostTaken(prefix.stages, prefix.cycle.size(), prefix.taken);
}

double StageRuns::bound_s(const CyclePrefix& prefix, double time_s, double fed_mm,
                          std::size_t setting, int taken) const {
    const double cut_mm = fed_mm - leastLag_mm(prefix, setting); // upper bound
    double rest_s =
        m_bound->rest_s(setting, cut_mm, m_grid.remainder(taken), prefix.isBeforeLast());
    if (const double sparkOut_s = m_bound->sparkOut_s(setting); sparkOut_s > 0) {
        rest_s = std::max(sparkOut_s - (time_s - prefix.time_s), 0.0) * (1 - 1e-9);
    }
    return time_s * (1 - 1e-12) + rest_s;
}

/// The least lag of the gauge's deepest radius in a last stage, for any number of steps.
double StageRuns::leastLag_mm(const CyclePrefix& prefix, std::size_t setting) const {
    if (!m_lags || !prefix.isBeforeLast()) {
        return 0;
    }
    const FollowedRadius& gauged = prefix.critical.radii[0];
    return std::max(std::min(prefix.critical.fed_mm - gauged.depth_mm, m_lags->least_mm()[setting]),
                    0.0);
}

void StageRuns::run(const CyclePrefix& from, std::size_t setting, const DropCheck& isDropped,
                    const AtEnd& atEnd, SearchCounts& counts) const {
    const auto runThrough = [&](Ends ends) {
        runTo(ends, from, *from.steps->copy(), setting, isDropped, atEnd, counts);
    };
    if (from.isBeforeLast()) {
        runThrough({0, 0});
    } else if (m_gauge) {
        runThrough({leastTaken(from), mostTaken(from)});
    } else {
        for (int taken = leastTaken(from); taken <= mostTaken(from); ++taken) {
            runThrough({taken, taken});
        }
    }
}

std::optional<StageRuns::End> StageRuns::runTo(int taken, const CyclePrefix& from,
                                               CycleSteps& steps, std::size_t setting,
                                               SearchCounts& counts) const {
    std::optional<End> reached;
    runTo(
        {taken, taken}, from, steps, setting, [](const Run&, int) { return false; },
        [&](const End& end) { reached.emplace(end); }, counts);
    return reached;
}

LastStageBound StageRuns::lastStageBound(const CyclePrefix& from, std::size_t setting,
                                         int mostSteps) const {
    return sparkout::lastStageBound(
        *m_part, from.critical,
        {m_feeds[setting], m_grid.settings()[setting].sparkOut, from.hasSteps(), mostSteps},
        m_cuts);
}

bool StageRuns::isTooDeep(const CyclePrefix& beforeLast) const {
    const auto& [gauged, one, other] = beforeLast.critical.radii;
    return canBoundLastStage()
           && m_cuts.isTooDeep(m_part->run().diameterDeviation(one.depth_mm, other.depth_mm));
}

void StageRuns::runTo(Ends ends, const CyclePrefix& from, CycleSteps& steps, std::size_t setting,
                      const DropCheck& isDropped, const AtEnd& atEnd, SearchCounts& counts) const {
    Run& run = steps.run();
    const long long visitsBefore = run.visits();
    const std::size_t stage = from.cycle.size();
    const bool last = from.isBeforeLast();
    const bool begun = from.hasSteps();
    const int sparkOut = m_grid.settings()[setting].sparkOut;
    GaugeSignal signal = from.signal.value_or(m_signal);
    for (int count = from.running;; ++count) {
        const int first = ends.taken;
        while ((begun || count > 0) && ends.taken <= ends.last
               && (sparkOut > 0 ? count >= sparkOut
                                : ended(run, signal, later(last, ends.taken), last))) {
            ++ends.taken;
        }
        if (ends.taken > first) {
            atEnd({steps, count, first, ends.taken - 1, signal});
        }
        if (ends.taken > ends.last || isDropped(run, ends.taken) || run.mustEnd()
            || !steps.step(nextFeed(later(last, ends.taken), setting, stage, run.fed_mm))) {
            break;
        }
        if (m_gauge) {
            signal.read(run.time_s(), steps.remaining());
        }
        if (const auto kind = m_cuts.broken(run, stage)) {
            ++counts.cuts[static_cast<std::size_t>(*kind)];
            break;
        }
    }
    counts.visits += run.visits() - visitsBefore;
}

CyclePrefix StageRuns::after(const CyclePrefix& from, std::size_t setting, const End& end,
                             int taken) const {
    CyclePrefix prefix;
    prefix.stages = from.stages;
    prefix.cycle = from.cycle;
    prefix.counts = from.counts;
    prefix.taken = taken;
    prefix.signal = end.signal;
    prefix.counts.push_back(end.count);
    prefix.cycle.push_back({setting, from.isBeforeLast() ? 0 : taken - from.taken});
    return prefix;
}

bool StageRuns::repeatSteps(const CyclePrefix& prefix, CycleSteps& steps, int count) const {
    int taken = 0, before = prefix.stepCount() - count;
    for (std::size_t stage = 0; stage < prefix.counts.size(); ++stage) {
        const auto& [setting, stock] = prefix.cycle[stage];
        taken += stock;
        const int done = std::min(before, prefix.counts[stage]);
        before -= done;
        for (int made = done; made < prefix.counts[stage]; ++made) {
            if (steps.run().mustEnd()
                || !steps.step(nextFeed(later(false, taken), setting, stage, steps.run().fed_mm))) {
                return false;
            }
        }
    }
    return true;
}

double StageRuns::later(bool last, int taken) const {
    return last ? 0 : m_grid.remainder(taken);
}

/// Under position control nothing is fed beyond the end of the stage.
StepFeed StageRuns::nextFeed(double later_mm, std::size_t setting, std::size_t stage,
                             double fed_mm) const {
    StepFeed feed = m_steps[setting];
    feed.stage = stage;
    if (!m_gauge) {
        feed.most_mm = m_fedAtSize_mm - later_mm;
        feed.infeed_mm = std::clamp(feed.most_mm - fed_mm, 0.0, feed.infeed_mm);
    }
    return feed;
}

bool StageRuns::ended(const Run& run, const GaugeSignal& signal, double later_mm, bool last) const {
    return m_gauge ? signal.isOver(later_mm, last)
                   : run.fed_mm >= m_fedAtSize_mm - later_mm - stageSlack_mm;
}

} // namespace sparkout
