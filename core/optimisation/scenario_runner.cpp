// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/scenario_runner.h"

#include <algorithm>
#include <tuple>

namespace sparkout {

bool ScenarioRunner::Before::operator()(const GridCycle& a, const GridCycle& b) const {
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(), [](const GridStage& x, const GridStage& y) {
            return std::tie(x.setting, x.steps) < std::tie(y.setting, y.steps);
        });
}

ScenarioRunner::ScenarioRunner(const Project& scenario, const Grid& grid, std::size_t memory_bytes,
                               const std::stop_token& stop)
    : m_runner(scenario, grid, stop), m_mostKept(memory_bytes / prefixBytes(scenario)) {
    if (memory_bytes > 0 && m_runner.isGauged()) {
        m_runs.emplace(scenario, grid, m_runner, StageRuns::Bounds::no);
    }
}

const CyclePrefix* ScenarioRunner::unrefutedPrefix(const GridCycle& cycle, SearchCounts& counts) {
    if (m_kept > m_mostKept) {
        m_known.clear();
        m_kept = 0;
    }
    const CyclePrefix& done = prefix(cycle, cycle.size() - 1, counts);
    if (!done.steps) {
        return nullptr;
    }
    if (m_runs->canBoundLastStage()
        && m_runs->lastStageBound(done, cycle.back().setting).cutsTooDeep) {
        ++counts.cuts[static_cast<std::size_t>(m_runner.cuts().tooDeep())];
        return nullptr;
    }
    return &done;
}

bool ScenarioRunner::refutes(const GridCycle& cycle, SearchCounts& counts) {
    return m_runs && !unrefutedPrefix(cycle, counts);
}

std::optional<SimulationResult> ScenarioRunner::run(const GridCycle& cycle, SearchCounts& counts) {
    if (!m_runs) {
        return m_runner.run(cycle, noTime_us, counts);
    }
    const CyclePrefix* const done = unrefutedPrefix(cycle, counts);
    if (!done) {
        return std::nullopt;
    }
    const std::size_t setting = cycle.back().setting;
    const std::unique_ptr<CycleSteps> steps = done->steps->copy();
    const auto end = m_runs->runTo(0, *done, *steps, setting, counts);
    if (!end) {
        return std::nullopt;
    }
    if (const auto broken = m_runner.cuts().brokenAtEnd(steps->run())) {
        ++counts.cuts[static_cast<std::size_t>(*broken)];
        return std::nullopt;
    }
    return m_runner.finish(cycle, *steps, m_runs->after(*done, setting, *end, 0).counts);
}

/// The first stages of the cycle, run on the first request.
const CyclePrefix& ScenarioRunner::prefix(const GridCycle& cycle, std::size_t stages,
                                          SearchCounts& counts) {
    const GridCycle first(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(stages));
    Prefixes& known = m_known[{cycle.size(), stages}];
    const auto found = known.find(first);
    if (found != known.end()) {
        return found->second;
    }
    ++m_kept;
    CyclePrefix done;
    if (stages == 0) {
        done.stages = cycle.size();
        done.keep(m_runner.begin(cycle.size()));
    } else if (const CyclePrefix& before = prefix(cycle, stages - 1, counts); before.steps) {
        done = extend(before, first, known, counts);
    }
    return known.emplace(first, std::move(done)).first->second;
}

/// Extends a run of its last stage from the furthest end before the requested one.
CyclePrefix ScenarioRunner::extend(const CyclePrefix& before, const GridCycle& wanted,
                                   const Prefixes& known, SearchCounts& counts) const {
    const GridStage stage = wanted.back();
    CyclePrefix from = before;
    if (auto nearest = known.lower_bound(wanted); nearest != known.begin()) {
        const auto& [cycle, done] = *--nearest;
        GridCycle same = wanted;
        same.back().steps = cycle.back().steps;
        if (cycle == same && !done.steps) {
            return {}; // a cut run stays cut
        }
        if (cycle == same) {
            from.keep(done.steps);
            from.running = done.counts.back();
            from.signal = done.signal;
        }
    }
    const int taken = before.taken + stage.steps;
    std::unique_ptr<CycleSteps> steps = from.steps->copy();
    const auto end = m_runs->runTo(taken, from, *steps, stage.setting, counts);
    if (!end) {
        return {};
    }
    CyclePrefix next = m_runs->after(before, stage.setting, *end, taken);
    next.keep(std::move(steps));
    return next;
}

} // namespace sparkout
