// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/robust.h"

#include "core/batch/batch_summary.h"
#include "core/batch/scenario_source.h"
#include "core/phases/sampled_phases.h"
#include "core/project/batch.h"
#include "core/project/optimisation.h"
#include "core/search/cycle_runner.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <numbers>
#include <numeric>
#include <utility>

namespace sparkout {

TradeOff tradeOff(const Project& project, const SearchSummary& quickest, SearchOptions options,
                  std::size_t most) {
    TradeOff found{{quickest}};
    while (found.cycles.size() < most) {
        const FeasibleCycle& last = *found.cycles.back().best;
        options.beyondMargin = last.leastRelativeMargin + equalMargins;
        options.quickest_us = last.time_us + 1; // it has the greatest margin of all with that time
        SearchSummary next = optimise(project, options);
        if (next.status != SearchStatus::proved) {
            found.isComplete = next.status == SearchStatus::infeasible;
            break;
        }
        found.cycles.push_back(std::move(next));
    }
    return found;
}

namespace {

/// Tries cycles on scenarios that correspond from draw to draw: first those that were the worst for
/// the last cycle tried on all, since a failing cycle mostly fails there.
class Trials {
public:
    /// A scenario in which the project's cycle fails; nullopt if there is none, or after a stop.
    std::optional<Project> failing(const Project& best, std::vector<Project> scenarios,
                                   const std::stop_token& stop) {
        const bool known = m_order.size() == scenarios.size();
        if (!known) {
            m_order.resize(scenarios.size());
            std::iota(m_order.begin(), m_order.end(), std::size_t{0});
        }
        std::vector<CycleTrial> trials(scenarios.size());
        for (const std::size_t i : m_order) {
            scenarios[i].cycle = best.cycle;
            const std::optional<CycleTrial> trial = tried(scenarios[i], stop);
            if (!trial) {
                return std::nullopt;
            }
            trials[i] = *trial;
            if (known && !trials[i].holds) {
                return std::move(scenarios[i]);
            }
        }
        std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) {
            return trials[a].leastMargin < trials[b].leastMargin;
        });
        const auto worst = std::find_if(m_order.begin(), m_order.end(),
                                        [&](std::size_t i) { return !trials[i].holds; });
        return worst == m_order.end() ? std::nullopt : std::optional(std::move(scenarios[*worst]));
    }

private:
    std::vector<std::size_t> m_order;
};

/// The scenarios of a draw: all corners of the project's batch, or its parts with another seed each
/// round.
std::vector<Project> partsOfBatch(Project sampled, OptimisationScenarios asked, int round,
                                  const std::stop_token& stop) {
    if (asked == OptimisationScenarios::corners) {
        sampled.batch->scenarios = Scenarios::corners;
    } else {
        constexpr unsigned mostSeed = std::numeric_limits<int>::max();
        const unsigned seed =
            static_cast<unsigned>(sampled.batch->seed) + static_cast<unsigned>(round);
        sampled.batch->seed = static_cast<int>(seed & mostSeed);
    }
    const ScenarioSource source(std::move(sampled));
    std::vector<Project> parts;
    for (std::int64_t part = 0; part < source.parts() && !stop.stop_requested(); ++part) {
        parts.push_back(source.project(part));
    }
    return parts;
}

bool areSame(const FeasibleCycle& a, const FeasibleCycle& b) {
    return a.variant == b.variant && a.cycle == b.cycle;
}

/// The number, from 1, of the last candidate that is this cycle; that of the last of all if there
/// is none.
int placeOf(const FeasibleCycle& cycle, const std::vector<FeasibleCycle>& candidates) {
    const auto last =
        std::find_if(candidates.rbegin(), candidates.rend(),
                     [&cycle](const FeasibleCycle& each) { return areSame(each, cycle); });
    const auto place = last == candidates.rend()
                           ? candidates.size()
                           : static_cast<std::size_t>(candidates.rend() - last);
    return std::max(static_cast<int>(place), 1);
}

/// Number of cycles that may be rejected for their batch's forecast alone: each costs a trial on
/// all fresh parts.
constexpr int mostIncapable = 50;

/// Runs a batch up to its first bad part, at most freshPartCount parts.
FreshPartsTrial triedOnParts(const Project& batch, const std::stop_token& stop) {
    const ScenarioSource source(batch);
    BatchSummary summary;
    summary.isSample = source.isSample();
    const std::vector<Characteristic> characteristics = characteristicsOf(source.nominal());
    for (const Characteristic& each : characteristics) {
        summary.characteristics.emplace_back().characteristic = each;
    }
    std::vector<double> squares(characteristics.size()); // of the distances from the mean, summed
    PartOutcome outcome;
    for (; summary.parts < std::min<std::int64_t>(source.parts(), freshPartCount);
         ++summary.parts) {
        Project part = source.project(summary.parts);
        const SimulationResult result = simulateUnchecked(part, nullptr, stop);
        if (result.status == RunStatus::stopped) {
            return {};
        }
        measure(result, characteristics, outcome);
        if (!outcome.good) {
            return {std::move(part), {}};
        }
        for (std::size_t i = 0; i < squares.size(); ++i) {
            CharacteristicSummary& of = summary.characteristics[i];
            const double from = outcome.values[i] - of.moments.mean;
            if (std::isfinite(from)) {
                of.moments.mean += from / static_cast<double>(++of.count);
                squares[i] += from * (outcome.values[i] - of.moments.mean);
            }
        }
    }
    FreshPartsTrial trial;
    trial.good.tried = static_cast<int>(summary.parts);
    for (std::size_t i = 0; i < squares.size(); ++i) {
        CharacteristicSummary& of = summary.characteristics[i];
        of.moments.deviation =
            std::sqrt(squares[i] / static_cast<double>(std::max<std::int64_t>(of.count - 1, 1)));
        if (summary.isSample) {
            addCapability(of);
        }
        if (of.ppk) {
            const double low = of.ppk->interval.low;
            trial.good.ppk = std::min(trial.good.ppk.value_or(low), low);
        }
    }
    BatchResult result;
    result.project = batch;
    trial.good.isCapable = !weigh(summary, result).missesForecast();
    return trial;
}

/// The project's own cycle, where the grid has it and the part as it stands meets every
/// requirement.
std::optional<FeasibleCycle> feasibleIn(const Variants& variants, const Project& project,
                                        const std::stop_token& stop) {
    for (std::size_t v = 0; v < variants.count(); ++v) {
        if (machineSettings(variants.project(v)) != machineSettings(project)) {
            continue;
        }
        if (auto cycle = variants.grid(v).find(*project.cycle)) {
            const std::optional<CycleTrial> trial = tried(project, stop);
            if (!trial || !trial->holds) {
                return std::nullopt;
            }
            const SimulationResult result = simulateUnchecked(project, nullptr, stop);
            if (hasIdleStage(result)) {
                return std::nullopt;
            }
            return FeasibleCycle{std::move(*cycle), comparedTime_us(result.time_s),
                                 trial->leastMargin, v, result.time_s};
        }
    }
    return std::nullopt;
}

/// Converts a part that does not belong to a case.
std::optional<FailingPart> failingPart(std::optional<Project> part) {
    return part ? std::optional(FailingPart{std::move(part), {}}) : std::nullopt;
}

/// The margins of cycles on all parts for which a robust answer must be fit.
class WholeMargins {
public:
    WholeMargins(const Project& project, const Variants& variants, const FreshScenarios& source,
                 std::stop_token stop)
        : m_project(project), m_variants(variants), m_source(source), m_stop(std::move(stop)) {}

    WholeMargin of(const FeasibleCycle& found, double least) {
        const std::scoped_lock lock(m_mutex); // called on the threads of a full search
        Project best = m_variants.project(found.variant);
        best.optimisation = m_project.optimisation;
        *best.cycle = m_variants.grid(found.variant).cycle(found.cycle);
        const std::optional<double> drawn = onScenarios(best, least);
        if (!drawn) {
            return {};
        }
        ++summary.candidates;
        if (canDecidePhases(best)) {
            const std::optional<ConstraintResult> worst = worstOfCases(best, least, m_stop);
            return {worst ? std::optional(std::min(*drawn, worst->relativeMargin)) : std::nullopt};
        }
        candidates.push_back(found);
        if (failingPhase(best, static_cast<std::uint32_t>(candidates.size()), m_stop)) {
            ++summary.freshFailures;
            return {};
        }
        return {drawn};
    }

    RobustSummary summary;
    std::vector<FeasibleCycle> candidates; ///< in the order of their tests on fresh phases

private:
    /// Begins with the scenario in which the last cycle failed or had too small a margin.
    std::optional<double> onScenarios(const Project& best, double least) {
        const std::vector<Project> scenarios = m_source(best, 0);
        double margin = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            const std::size_t at = (m_worst + i) % scenarios.size();
            Project scenario = scenarios[at];
            scenario.cycle = best.cycle;
            const std::optional<CycleTrial> trial = tried(scenario, m_stop);
            if (!trial || !trial->holds || trial->leastMargin < least) {
                m_worst = at;
                return std::nullopt;
            }
            margin = std::min(margin, trial->leastMargin);
        }
        return margin;
    }

    const Project& m_project;
    const Variants& m_variants;
    const FreshScenarios& m_source;
    std::stop_token m_stop;
    std::size_t m_worst = 0;
    std::mutex m_mutex;
};

RobustSummary greatestMargin(const Project& project, const FreshScenarios& source,
                             SearchOptions search) {
    const Variants variants(project, search.stop);
    WholeMargins margins(project, variants, source, search.stop);
    search.wholeMargin = [&margins](const FeasibleCycle& found, double least) {
        return margins.of(found, least);
    };
    RobustSummary summary;
    SearchSummary found = optimise(project, search);
    summary = margins.summary;
    summary.search = std::move(found);
    summary.rounds = 1;
    summary.evaluations = summary.search.evaluations;
    summary.visits = summary.search.visits;
    if (!summary.search.best) {
        return summary;
    }
    summary.holdsInSample = true;
    summary.candidate = placeOf(*summary.search.best, margins.candidates);
    if (canDecidePhases(project)) {
        summary.decided = phaseCases(withBest(project, summary.search));
    } else {
        summary.freshPhases = freshPhaseCount;
    }
    return summary;
}

/// The search of optimiseRobustly() for the least time.
class RobustSearch {
public:
    RobustSearch(const Project& project, const FreshScenarios& source, const RobustOptions& options)
        : m_project(project)
        , m_source(source)
        , m_stop(options.search.stop)
        , m_mostRounds(options.mostRounds)
        , m_known(options.known)
        , m_search(options.search)
        , m_asksCapability(!isHeuristic(m_search.method))
        , m_variants(project, m_stop) {
        m_search.everyStageSteps = true;
    }

    RobustSummary run() {
        // Other methods than the pruned one repeat the search for each rejected cycle.
        while (m_summary.rounds < m_mostRounds + m_summary.incapable && !isDone()) {
        }
        return std::move(m_summary);
    }

private:
    /// A cycle that passed all of its tests.
    struct Held {
        FeasibleCycle cycle;
        FreshParts parts;
    };

    /// Makes a round; returns whether it was the last.
    bool isDone() {
        optimiseOnce();
        if (m_summary.search.isStale && !m_stop.stop_requested()) {
            m_search.incumbent.reset(); // it may be the one that fails in a part added later
            return false;               // repeats the search with the added parts
        }
        if (mustTakeIncapable()) {
            m_asksCapability = false;
            m_search.rejected.clear();
            m_search.incumbent.reset(); // slower than those that were rejected
            return false;
        }
        std::optional<FeasibleCycle>& best = m_summary.search.best;
        if (!best || m_summary.search.status == SearchStatus::stopped) {
            if (m_summary.search.isStale) {
                best.reset(); // it fails in a scenario
            } else if (best && heldOf(*best)) {
                takeBest(); // the best found before the stop
            }
            return true;
        }
        auto failing = m_search.challenge ? std::nullopt : challenge(*best);
        if (m_stop.stop_requested() && !m_search.challenge) {
            m_summary.search.status = SearchStatus::stopped; // during its test
            return true;
        }
        if (!failing) { // its own challenge was drawn
            takeBest();
            return true;
        }
        add(std::move(*failing));
        m_search.quickest_us = best->time_us; // further scenarios speed nothing up
        if (m_summary.search.status == SearchStatus::proved) {
            m_proved_s = best->time_s;
        }
        if (m_search.method == SearchMethod::pruned) {
            m_search.incumbent = knownCycle();
            m_search.challenge = [this](const FeasibleCycle& found) { return challenge(found); };
        }
        return false;
    }

    void optimiseOnce() {
        SearchSummary& found = m_summary.search;
        found = optimise(m_project, m_search);
        m_summary.evaluations += found.evaluations;
        m_summary.visits += found.visits;
        if (found.status == SearchStatus::stopped) {
            found.bound_s = std::max(found.bound_s, m_proved_s);
        }
        if (m_summary.rounds++ == 0 && found.best) {
            m_summary.nominalTime_s = found.best->time_s;
        }
        for (Project& scenario : found.added) {
            m_search.scenarios.push_back(scenario);
            m_summary.added.push_back(std::move(scenario));
        }
        std::ranges::move(found.addedCases, std::back_inserter(m_search.cases));
    }

    /// Whether the search must be repeated without requiring capability: no cycle has it, or too
    /// many lack it.
    [[nodiscard]] bool mustTakeIncapable() {
        const bool hasNone =
            !m_summary.search.best && m_summary.search.status == SearchStatus::infeasible;
        return m_summary.incapable > 0 && (hasNone || !m_asksCapability)
               && !std::exchange(m_takesIncapable, true);
    }

    std::optional<FailingPart> challenge(const FeasibleCycle& found) {
        auto failing = failsBeforeParts(found);
        return failing || m_stop.stop_requested() ? std::move(failing) : failsOnParts(found);
    }

    /// A part on which a cycle fails: of a case, of the source's scenarios or of fresh phases.
    std::optional<FailingPart> failsBeforeParts(const FeasibleCycle& found) {
        const Project best = projectOf(found);
        const bool canDecide = canDecidePhases(best);
        auto failing = canDecide ? m_cases.failingInKnownCase(best, m_stop) : std::nullopt;
        if (!failing) {
            failing = failingPart(m_trials.failing(best, m_source(best, m_draws++), m_stop));
            if (!failing && !m_stop.stop_requested()) {
                m_candidates.push_back(found);
                ++m_summary.candidates;
                failing = canDecide ? m_cases.failingInOtherCase(best, m_stop)
                                    : failingPart(failingPhase(
                                        best, static_cast<std::uint32_t>(m_draws), m_stop));
                m_summary.freshFailures += failing ? 1 : 0;
            }
        }
        return failing;
    }

    /// A fresh part of the batch on which a cycle fails; none, but a rejection, if the cycle is not
    /// capable. A cycle that passes is held.
    std::optional<FailingPart> failsOnParts(const FeasibleCycle& found) {
        FreshPartsTrial trial =
            triedOnFreshParts(projectOf(found), freshDraw(found.time_us), m_stop);
        if (m_stop.stop_requested()) {
            return std::nullopt;
        }
        auto failing = failingPart(std::move(trial.bad));
        m_summary.freshFailures += failing ? 1 : 0;
        if (!failing && !trial.good.isCapable && m_asksCapability) {
            m_asksCapability = ++m_summary.incapable < mostIncapable;
            m_search.rejected.push_back(found);
            failing = FailingPart{};
        }
        if (!failing) {
            m_held.push_back({found, trial.good});
        }
        return failing;
    }

    /// The project's own cycle, or a known one, if it passes all tests of an answer. The search
    /// goes from the quickest cycle upwards and has no answer before its end: this one is to be
    /// beaten, and the answer if the search is stopped. An own one that is much slower than the
    /// quickest for the part alone is neither.
    std::optional<FeasibleCycle> knownCycle() {
        constexpr double mostTimes = 2;
        auto found = passing(m_project, mostTimes * m_summary.nominalTime_s);
        for (const Cycle& cycle : m_known) {
            if (found || m_stop.stop_requested()) {
                break;
            }
            Project with = m_project;
            *with.cycle = cycle;
            found = passing(with, std::numeric_limits<double>::infinity());
        }
        return found;
    }

    /// The cycle of a project, if it takes no longer than this [s] and passes all tests.
    std::optional<FeasibleCycle> passing(const Project& project, double most_s) {
        std::optional<FeasibleCycle> own = feasibleIn(m_variants, project, m_stop);
        if (own && own->time_s > most_s) {
            return std::nullopt;
        }
        for (const Project& scenario : m_search.scenarios) {
            Project part = scenario;
            part.cycle = project.cycle;
            setMachine(part, machineSettings(m_project));
            const auto trial = own ? tried(part, m_stop) : std::nullopt;
            if (!trial || !trial->holds) {
                return std::nullopt;
            }
            own->leastRelativeMargin = std::min(own->leastRelativeMargin, trial->leastMargin);
        }
        if (!own || (m_search.beyondMargin && own->leastRelativeMargin <= *m_search.beyondMargin)) {
            return std::nullopt;
        }
        auto failing = challenge(*own);
        if (!failing) {
            return m_stop.stop_requested() ? std::nullopt : own;
        }
        add(std::move(*failing));
        return std::nullopt;
    }

    void add(FailingPart failing) {
        if (failing.part) {
            m_search.scenarios.push_back(*failing.part);
            m_summary.added.push_back(std::move(*failing.part));
        }
        if (failing.of) {
            m_search.cases.push_back(std::move(*failing.of));
        }
    }

    void takeBest() {
        const FeasibleCycle& best = *m_summary.search.best;
        m_summary.candidate = placeOf(best, m_candidates);
        m_summary.holdsInSample = true;
        if (const Held* const held = heldOf(best)) {
            m_summary.freshParts = held->parts;
        }
        if (canDecidePhases(m_project)) {
            m_summary.decided = phaseCases(projectOf(best));
        } else {
            m_summary.freshPhases = freshPhaseCount;
        }
    }

    [[nodiscard]] const Held* heldOf(const FeasibleCycle& cycle) const {
        const auto held = std::ranges::find_if(
            m_held, [&](const Held& each) { return areSame(each.cycle, cycle); });
        return held == m_held.end() ? nullptr : &*held;
    }

    [[nodiscard]] Project projectOf(const FeasibleCycle& found) const {
        Project project = m_variants.project(found.variant);
        project.optimisation = m_project.optimisation;
        *project.cycle = m_variants.grid(found.variant).cycle(found.cycle);
        return project;
    }

    const Project& m_project;
    const FreshScenarios& m_source;
    std::stop_token m_stop;
    int m_mostRounds;
    std::vector<Cycle> m_known;
    SearchOptions m_search;
    bool m_asksCapability;         ///< a heuristic does not leave out cycles that are rejected
    bool m_takesIncapable = false; ///< the search was repeated without requiring capability
    Variants m_variants;
    RobustSummary m_summary;
    int m_draws = 0;       ///< from the source
    double m_proved_s = 0; ///< no cycle is quicker: the answer of an earlier round
    Trials m_trials;
    CaseOrder m_cases;
    std::vector<FeasibleCycle> m_candidates; ///< in the order of their tests on fresh phases
    std::vector<Held> m_held;
};

} // namespace

int freshDraw(std::int64_t time_us) {
    constexpr std::int64_t draws = 1'000'000;
    return static_cast<int>(time_us % draws) + 1;
}

FreshPartsTrial triedOnFreshParts(const Project& best, int draw, const std::stop_token& stop) {
    if (!best.batch || best.optimisation->scenarios != OptimisationScenarios::corners) {
        return {};
    }
    FreshPartsTrial own = triedOnParts(best, stop);
    if (own.bad || stop.stop_requested()) {
        return own;
    }
    FreshPartsTrial fresh = triedOnParts(withFreshParts(best, draw), stop);
    fresh.good.isCapable &= own.good.isCapable;
    if (own.good.ppk && fresh.good.ppk) {
        fresh.good.ppk = std::min(*own.good.ppk, *fresh.good.ppk);
    }
    return fresh;
}

RobustSummary optimiseRobustly(const Project& asked, const FreshScenarios& source,
                               const RobustOptions& options) {
    Project project = asked; // copied for each scenario
    project.runs.clear();
    project.notes.clear();
    if (options.search.marginWithin_us) {
        SearchOptions search = options.search;
        search.everyStageSteps = true;
        return greatestMargin(project, source, std::move(search));
    }
    return RobustSearch(project, source, options).run();
}

TradeOff tradeOffRobustly(const Project& asked, const FreshScenarios& source, SearchOptions search,
                          std::size_t most) {
    Project project = asked;
    project.runs.clear();
    project.notes.clear();
    if (!canDecidePhases(project)) {
        return {};
    }
    const Variants variants(project, search.stop);
    WholeMargins margins(project, variants, source, search.stop);
    search.everyStageSteps = true;
    search.wholeMargin = [&margins](const FeasibleCycle& found, double least) {
        return margins.of(found, least);
    };
    const SearchSummary quickest = optimise(project, search);
    return quickest.status == SearchStatus::proved
               ? tradeOff(project, quickest, std::move(search), most)
               : TradeOff{};
}

FreshScenarios scenariosAskedFor(const Project& project, const std::stop_token& stop) {
    const OptimisationScenarios asked = project.optimisation->scenarios;
    if (!areOfBatch(asked) || !project.batch) {
        return freshStockPhases;
    }
    return [asked, stop](const Project& best, int round) {
        std::vector<Project> scenarios = freshStockPhases(best, round);
        std::ranges::move(partsOfBatch(best, asked, round, stop), std::back_inserter(scenarios));
        return scenarios;
    };
}

FreshScenarios undecidedScenarios(const Project& project, const std::stop_token& stop) {
    if (!canDecidePhases(project)) {
        return scenariosAskedFor(project, stop);
    }
    const OptimisationScenarios asked = project.optimisation->scenarios;
    return [asked, stop](const Project& best, int round) {
        return asked == OptimisationScenarios::batch && best.batch
                   ? partsOfBatch(best, asked, round, stop)
                   : std::vector<Project>{};
    };
}

// Multiples of the golden section modulo 1 fill the unit interval evenly.
std::vector<Project> freshStockPhases(const Project& best, int round) {
    const double turns = (std::numbers::phi - 1) * round;
    return stockPhases(best, 16, turns - std::floor(turns));
}

} // namespace sparkout
