// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/judge.h"

#include <algorithm>
#include <tuple>
#include <utility>

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

bool isBetter(const FeasibleCycle& a, const FeasibleCycle& b, const Grid& grid, SearchAim aim) {
    if (aim == SearchAim::greatestMargin && a.leastRelativeMargin != b.leastRelativeMargin) {
        return a.leastRelativeMargin > b.leastRelativeMargin;
    }
    if (a.time_us != b.time_us) {
        return a.time_us < b.time_us;
    }
    if (a.leastRelativeMargin != b.leastRelativeMargin) {
        return a.leastRelativeMargin > b.leastRelativeMargin;
    }
    return a.variant != b.variant ? a.variant < b.variant : grid.before(a.cycle, b.cycle);
}

Judge::Judge(const Grid& grid, const SearchOptions& options)
    : m_grid(grid), m_options(options), m_best(options.incumbent) {
    const std::vector<Project>& scenarios = options.scenarios;
    m_scenarios.reserve(scenarios.size());
    for (const Project& scenario : scenarios) {
        if (options.stop.stop_requested()) {
            break; // and a cycle will not be run to its end
        }
        m_scenarios.push_back(runner(scenario, scenarios.size()));
    }
    for (const PhaseCase& each : options.cases) {
        add(each);
    }
    demandMargin();
}

double Judge::demandedMargin() const {
    constexpr double none = -std::numeric_limits<double>::infinity();
    const double best =
        m_options.marginWithin_us && m_best ? m_best->leastRelativeMargin : none; // ties may win
    return std::max(best, m_options.beyondMargin.value_or(none));
}

/// The full search, as the reference, does not cut by margin.
void Judge::demandMargin() {
    if (m_options.method != SearchMethod::full) {
        for (const auto& scenario : m_scenarios) {
            scenario->demandMargin(demandedMargin());
        }
    }
}

/// Makes the runner of a scenario; all of them share a quarter of `memory_bytes`. The full search,
/// as the reference, shares no runs.
std::unique_ptr<ScenarioRunner> Judge::runner(const Project& scenario, std::size_t among) const {
    const bool shares = m_options.method != SearchMethod::full;
    return std::make_unique<ScenarioRunner>(
        scenario, m_grid, shares ? m_options.memory_bytes / 4 / among : 0, m_options.stop);
}

/// Adds a case; all cases share an eighth of `memory_bytes`. The full search refutes nothing.
void Judge::add(const PhaseCase& of) {
    const bool isKnown =
        std::ranges::any_of(m_cases, [&](const auto& each) { return each->corner() == of.corner; });
    if (m_options.method == SearchMethod::pruned && !isKnown && !m_options.stop.stop_requested()) {
        m_cases.push_back(std::make_unique<CaseRefuter>(
            of, m_grid, m_options.memory_bytes / 8 / (m_cases.size() + 1), m_options.stop));
    }
}

std::optional<double> Judge::leastMargin(const SimulationResult& result) {
    if (result.status != RunStatus::completed) {
        return std::nullopt;
    }
    bool holds = true;
    double least = std::numeric_limits<double>::infinity();
    for (const ConstraintResult& constraint : worstByKind(evaluateConstraints(result))) {
        least = std::min(least, constraint.relativeMargin);
        if (!constraint.holds) {
            holds = false;
            ++counts.cuts[static_cast<std::size_t>(constraint.kind)];
        }
    }
    return holds ? std::optional(least) : std::nullopt;
}

std::optional<double> Judge::leastMargin(const GridCycle& cycle, double margin) {
    for (auto& scenario : m_scenarios) {
        const auto result = scenario->run(cycle, counts);
        const std::optional<double> there = result ? leastMargin(*result) : std::nullopt;
        if (!there) {
            std::swap(m_scenarios.front(), scenario);
            return std::nullopt;
        }
        margin = std::min(margin, *there);
    }
    return margin;
}

bool Judge::judge(const GridCycle& cycle, const SimulationResult& result, int merged) {
    ++counts.evaluations;
    FeasibleCycle found{cycle, comparedTime_us(result.time_s), 0, m_options.variant, result.time_s};
    if (found.time_us > mostTime_us() || (m_options.everyStageSteps && hasIdleStage(result))) {
        return false;
    }
    const std::optional<double> margin = leastMargin(result);
    const int all = m_scenarios.empty() && !m_options.challenge && !m_options.wholeMargin
                        ? 0
                        : merged; // in grid order the first precedes the others
    const bool waits = m_options.challenge && m_options.method == SearchMethod::pruned;
    bool best = false;
    for (int more = 0; margin && more <= all; ++more) {
        found.leastRelativeMargin = *margin;
        if (*margin >= demandedMargin() && !isRejected(found) && holdsOnScenarios(found)
            && holdsOnAll(found)) {
            if (waits) {
                m_waiting.push_back(found);
            }
            best |= waits || offer(found);
        }
        if (more < all) {
            ++found.cycle[cycle.size() - 2].steps;
        }
    }
    return best;
}

bool Judge::isRejected(const FeasibleCycle& found) const {
    return std::ranges::any_of(m_options.rejected, [&found](const FeasibleCycle& each) {
        return each.variant == found.variant && each.cycle == found.cycle;
    });
}

bool Judge::holdsOnScenarios(FeasibleCycle& found) {
    const auto least = leastMargin(found.cycle, found.leastRelativeMargin);
    found.leastRelativeMargin = least.value_or(0);
    return least && (!m_options.beyondMargin || *least > *m_options.beyondMargin);
}

bool Judge::holdsOnAll(FeasibleCycle& found) {
    if (!m_options.wholeMargin) {
        return true;
    }
    if (m_best && !isBetter(found, *m_best, m_grid, m_options.aim())) {
        return false; // its margin is at most that
    }
    const WholeMargin whole = m_options.wholeMargin(found, demandedMargin());
    if (!whole.margin || m_options.stop.stop_requested()) {
        return false; // a stopped test proves nothing
    }
    found.leastRelativeMargin = std::min(found.leastRelativeMargin, *whole.margin);
    return !m_options.beyondMargin || found.leastRelativeMargin > *m_options.beyondMargin;
}

void Judge::challengeWaiting(double time_s) {
    const auto before = [&](const FeasibleCycle& a, const FeasibleCycle& b) {
        return isBetter(a, b, m_grid);
    };
    while (!m_waiting.empty() && !m_stale && !m_options.stop.stop_requested()) {
        const auto first = std::min_element(m_waiting.begin(), m_waiting.end(), before);
        if (seconds(first->time_us) > time_s || (m_best && !before(*first, *m_best))) {
            return;
        }
        FeasibleCycle found = *first;
        const bool holds = holdsOnScenarios(found);
        if (m_options.stop.stop_requested()) {
            return; // it remains waiting, and its time is a bound
        }
        if (holds && found.leastRelativeMargin < first->leastRelativeMargin) {
            *first = found; // another may be the best now
            continue;
        }
        const bool challenged = holds && isChallenged(found);
        if (challenged && m_options.stop.stop_requested()) {
            return; // it remains waiting
        }
        m_waiting.erase(first);
        if (holds && !challenged) {
            put(found);
        }
    }
}

double Judge::leastWaiting_s() const {
    double least_s = seconds(noTime_us);
    for (const FeasibleCycle& each : m_waiting) {
        least_s = std::min(least_s, each.time_s);
    }
    return least_s;
}

/// Replaces the best cycle, which keeps waiting if its time is equal.
void Judge::put(const FeasibleCycle& found) {
    const bool tie = m_best && m_best->time_us == found.time_us;
    if (tie && m_best->variant == found.variant) {
        m_waiting.push_back(*m_best);
    }
    m_beatOther = tie && (m_beatOther || m_best->variant != found.variant);
    offer(found);
}

bool Judge::isRefuted(GridCycle cycle, int merged) {
    for (int more = 0; more <= merged; ++more) {
        if (!isCycleRefuted(cycle) || m_options.stop.stop_requested()) {
            return false;
        }
        if (more < merged) {
            ++cycle[cycle.size() - 2].steps;
        }
    }
    ++counts.evaluations;
    return true;
}

void Judge::keepRefuted(GridCycle beforeLast, int merged, std::vector<std::size_t>& settings) {
    if (m_cases.empty()) {
        settings.clear();
    }
    for (int more = 0; more <= merged && !settings.empty(); ++more) {
        m_cases.front()->keepRefuted(beforeLast, settings);
        ++beforeLast.back().steps;
    }
}

/// Tries the case that refuted the last cycle first.
bool Judge::isRefutedByCase(const GridCycle& cycle) {
    const auto deep = std::find_if(m_cases.begin(), m_cases.end(),
                                   [&](const auto& each) { return each->refutes(cycle); });
    if (deep == m_cases.end()) {
        return false;
    }
    ++counts.cuts[static_cast<std::size_t>((*deep)->tooDeep())];
    std::iter_swap(m_cases.begin(), deep);
    return true;
}

/// Tries the scenario that failed last first.
bool Judge::isCycleRefuted(const GridCycle& cycle) {
    if (isRefutedByCase(cycle)) {
        return true;
    }
    const auto failing =
        std::find_if(m_scenarios.begin(), m_scenarios.end(),
                     [&](const auto& each) { return each->refutes(cycle, counts); });
    if (failing == m_scenarios.end()) {
        return false;
    }
    std::iter_swap(m_scenarios.begin(), failing);
    return true;
}

bool Judge::decide(const GridCycle& cycle, CycleRunner& runner) {
    const SearchCounts before = counts;
    const auto result = runner.run(cycle, mostTime_us(), counts);
    const bool best = result && judge(cycle, *result);
    if (!result) {
        ++counts.evaluations;
    }
    if (m_options.stop.stop_requested() && !best) { // possibly within a run: nothing is decided
        counts = before;
    }
    return best;
}

void Judge::decideDone(const CyclePrefix& whole, CycleSteps& steps, CycleRunner& runner,
                       int merged) {
    const std::int64_t time_us = comparedTime_us(steps.run().time_s());
    if (time_us > mostTime_us()) {
        return;
    }
    if (m_options.method == SearchMethod::pruned && time_us < m_options.quickest_us) {
        ++counts.evaluations; // judged earlier
    } else if (!runner.isGauged()) {
        decide(whole.cycle, runner);
    } else if (const auto broken = runner.cuts().brokenAtEnd(steps.run())) {
        cut(*broken);
    } else {
        judge(whole.cycle, runner.finish(whole.cycle, steps, whole.counts), merged);
    }
}

/// Returns whether the challenge rejects the cycle; the best cycle must be fit for the part on
/// which it fails, too.
bool Judge::isChallenged(const FeasibleCycle& found) {
    auto failing = m_options.challenge(found);
    if (m_options.stop.stop_requested()) {
        return true; // a stopped test proves nothing
    }
    if (!failing) {
        return false;
    }
    if (!failing->part) {
        return true; // rejected, without a part for which the others must be fit
    }
    auto further = runner(*failing->part, m_scenarios.size() + 1);
    std::optional<SimulationResult> result;
    if (m_best && m_best->variant == m_options.variant) {
        result = further->run(m_best->cycle, counts);
        if (m_options.stop.stop_requested()) {
            return true; // whether the best is fit for it is unknown: it is dropped
        }
    }
    m_scenarios.insert(m_scenarios.begin(), std::move(further));
    m_added.push_back(std::move(*failing->part));
    if (failing->of) {
        add(*failing->of);
        m_addedCases.push_back(std::move(*failing->of));
    }
    if (m_best && m_best->variant == m_options.variant) {
        const auto margin = result ? leastMargin(*result) : std::nullopt;
        m_stale = m_stale || !margin || (m_beatOther && *margin < m_best->leastRelativeMargin);
        m_best->leastRelativeMargin = std::min(m_best->leastRelativeMargin, margin.value_or(0));
    } else {
        m_stale = m_stale || m_best;
    }
    return true;
}

bool Judge::offer(const FeasibleCycle& found) {
    if (m_best && !isBetter(found, *m_best, m_grid, m_options.aim())) {
        return false;
    }
    m_best = found;
    if (m_options.marginWithin_us) {
        demandMargin();
    }
    return true;
}

} // namespace sparkout
