// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/robust.h"

#include "core/batch/scenario_source.h"
#include "core/optimisation/cycle_runner.h"
#include "core/phases/cycle_trial.h"
#include "core/project/batch.h"
#include "core/project/optimisation.h"
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

/// The number, from 1, of the last candidate that is this cycle; that of the last of all if there
/// is none.
int placeOf(const FeasibleCycle& cycle, const std::vector<FeasibleCycle>& candidates) {
    const auto last =
        std::find_if(candidates.rbegin(), candidates.rend(), [&cycle](const FeasibleCycle& each) {
            return each.variant == cycle.variant && each.cycle == cycle.cycle;
        });
    const auto place = last == candidates.rend()
                           ? candidates.size()
                           : static_cast<std::size_t>(candidates.rend() - last);
    return std::max(static_cast<int>(place), 1);
}

/// A part in which the cycle fails: of the batch, whose verdict is shown beside the answer, or of
/// those drawn for the cycle; nullopt if there is none, after a stop, or if the answer is not for
/// corners of a batch.
std::optional<Project> failingFreshPart(const Project& best, int draw,
                                        const std::stop_token& stop) {
    if (!best.batch || best.optimisation->scenarios != OptimisationScenarios::corners) {
        return std::nullopt;
    }
    for (const Project& batch : {best, withFreshParts(best, draw)}) {
        const ScenarioSource source(batch);
        const auto parts = std::min<std::int64_t>(source.parts(), freshPartCount);
        for (std::int64_t part = 0; part < parts; ++part) {
            Project drawn = source.project(part);
            const std::optional<CycleTrial> trial = tried(drawn, stop);
            if (!trial || !trial->holds) {
                return trial ? std::optional(std::move(drawn)) : std::nullopt;
            }
        }
    }
    return std::nullopt;
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
    return part ? std::optional(FailingPart{std::move(*part), {}}) : std::nullopt;
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

} // namespace

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
    RobustSummary summary;
    SearchOptions search = options.search;
    search.everyStageSteps = true;
    const Variants variants(project, search.stop);
    int draws = 0;       // from the source
    double proved_s = 0; // no cycle is quicker: the answer of an earlier round
    Trials trials;
    CaseOrder cases;
    std::vector<FeasibleCycle> candidates; // in the order of their tests on fresh phases
    std::vector<FeasibleCycle> held;       // passed all of their tests
    const auto challenge = [&](const FeasibleCycle& found) {
        Project best = variants.project(found.variant);
        best.optimisation = project.optimisation;
        *best.cycle = variants.grid(found.variant).cycle(found.cycle);
        const std::stop_token& stop = options.search.stop;
        const bool canDecide = canDecidePhases(best);
        auto failing = canDecide ? cases.failingInKnownCase(best, stop) : std::nullopt;
        if (failing) {
            return failing;
        }
        failing = failingPart(trials.failing(best, source(best, draws++), stop));
        if (!failing && !stop.stop_requested()) {
            candidates.push_back(found);
            ++summary.candidates;
            failing =
                canDecide
                    ? cases.failingInOtherCase(best, stop)
                    : failingPart(failingPhase(best, static_cast<std::uint32_t>(draws), stop));
            if (!failing && !stop.stop_requested()) {
                failing = failingPart(failingFreshPart(best, summary.candidates, stop));
            }
            summary.freshFailures += failing ? 1 : 0;
            if (!failing && !stop.stop_requested()) {
                held.push_back(found);
            }
        }
        return failing;
    };
    const auto takeBest = [&] {
        summary.candidate = placeOf(*summary.search.best, candidates);
        summary.holdsInSample = true;
        if (project.batch && project.optimisation->scenarios == OptimisationScenarios::corners) {
            summary.freshParts = freshPartCount;
        }
        if (canDecidePhases(project)) {
            Project best = variants.project(summary.search.best->variant);
            *best.cycle = summary.search.cycle;
            summary.decided = phaseCases(best);
        } else {
            summary.freshPhases = freshPhaseCount;
        }
    };
    const auto optimised = [&](const SearchOptions& how) {
        SearchSummary found = optimise(project, how);
        summary.evaluations += found.evaluations;
        summary.visits += found.visits;
        return found;
    };
    const auto addPart = [&](FailingPart failing) {
        search.scenarios.push_back(failing.part);
        summary.added.push_back(std::move(failing.part));
        if (failing.of) {
            search.cases.push_back(std::move(*failing.of));
        }
    };
    // The search goes from the quickest cycle upwards and has no answer before its end. The cycle
    // that the project has is to be beaten, and the answer if the search is stopped.
    const auto ownCycle = [&]() -> std::optional<FeasibleCycle> {
        std::optional<FeasibleCycle> own = feasibleIn(variants, project, search.stop);
        for (const Project& scenario : search.scenarios) {
            Project part = scenario;
            part.cycle = project.cycle;
            setMachine(part, machineSettings(project));
            const auto trial = own ? tried(part, search.stop) : std::nullopt;
            if (!trial || !trial->holds) {
                return std::nullopt;
            }
            own->leastRelativeMargin = std::min(own->leastRelativeMargin, trial->leastMargin);
        }
        if (!own || (search.beyondMargin && own->leastRelativeMargin <= *search.beyondMargin)) {
            return std::nullopt;
        }
        auto failing = challenge(*own);
        if (!failing) {
            return options.search.stop.stop_requested() ? std::nullopt : own;
        }
        addPart(std::move(*failing));
        return std::nullopt;
    };
    while (summary.rounds < options.mostRounds) {
        summary.search = optimised(search);
        if (summary.search.status == SearchStatus::stopped) {
            summary.search.bound_s = std::max(summary.search.bound_s, proved_s);
        }
        if (summary.rounds++ == 0 && summary.search.best) {
            summary.nominalTime_s = summary.search.best->time_s;
        }
        for (Project& scenario : summary.search.added) {
            search.scenarios.push_back(scenario);
            summary.added.push_back(std::move(scenario));
        }
        std::ranges::move(summary.search.addedCases, std::back_inserter(search.cases));
        if (summary.search.isStale && !options.search.stop.stop_requested()) {
            search.incumbent.reset(); // it may be the one that fails in a part added later
            continue;                 // repeats the search with the added parts
        }
        if (!summary.search.best || summary.search.status == SearchStatus::stopped) {
            if (summary.search.isStale) {
                summary.search.best.reset(); // it fails in a scenario
            } else if (summary.search.best
                       && std::ranges::any_of(held, [&](const FeasibleCycle& each) {
                              return each.variant == summary.search.best->variant
                                     && each.cycle == summary.search.best->cycle;
                          })) {
                takeBest(); // the best found before the stop
            }
            return summary;
        }
        auto failing = search.challenge ? std::nullopt : challenge(*summary.search.best);
        if (options.search.stop.stop_requested() && !search.challenge) {
            summary.search.status = SearchStatus::stopped; // during its test
            return summary;
        }
        if (!failing) { // its own challenge was drawn
            takeBest();
            return summary;
        }
        addPart(std::move(*failing));
        search.quickest_us = summary.search.best->time_us; // further scenarios speed nothing up
        if (summary.search.status == SearchStatus::proved) {
            proved_s = summary.search.best->time_s;
        }
        if (search.method == SearchMethod::pruned) {
            search.incumbent = ownCycle();
            search.challenge = challenge;
        }
    }
    return summary;
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
