// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/robust.h"

#include "core/batch/scenario_source.h"
#include "core/simulation/simulate.h"
#include "core/simulation/stage_control.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace sparkout {

namespace {

/// The least relative margin of what fails; 0 when all holds.
double worstFailure(const SimulationResult& result) {
    if (result.status != RunStatus::completed) {
        return -std::numeric_limits<double>::infinity();
    }
    double worst = 0;
    for (const ConstraintResult& constraint : evaluateConstraints(result)) {
        if (!constraint.holds) {
            worst = std::min(worst, constraint.relativeMargin);
        }
    }
    return worst;
}

/// The scenario in which the project's cycle fails by most.
std::optional<Project> worstFailing(const Project& best, std::vector<Project> scenarios) {
    double worst = 0;
    std::optional<Project> failing;
    for (Project& scenario : scenarios) {
        scenario.cycle = best.cycle;
        const double failure = worstFailure(simulate(scenario));
        if (failure < worst) {
            worst = failure;
            failing = std::move(scenario);
        }
    }
    return failing;
}

} // namespace

RobustSummary optimiseRobustly(const Project& project, const FreshScenarios& source,
                               const RobustOptions& options) {
    RobustSummary summary;
    SearchOptions search = options.search;
    const Variants variants(project);
    int draws = 0; // from the source
    const auto challenge = [&](const FeasibleCycle& found) {
        Project best = variants.project(found.variant);
        best.optimisation = project.optimisation;
        best.cycle = variants.grid(found.variant).cycle(found.cycle);
        return worstFailing(best, source(best, draws++));
    };
    while (summary.rounds < options.mostRounds) {
        summary.search = optimise(project, search);
        summary.evaluations += summary.search.evaluations;
        summary.visits += summary.search.visits;
        if (summary.rounds++ == 0 && summary.search.best) {
            summary.nominalTime_us = summary.search.best->time_us;
        }
        for (Project& scenario : summary.search.added) {
            search.scenarios.push_back(scenario);
            summary.added.push_back(std::move(scenario));
        }
        if (summary.search.isStale) {
            continue; // with its best in none of them
        }
        if (!summary.search.best || summary.search.status == SearchStatus::stopped) {
            return summary;
        }
        auto failing = search.challenge ? std::nullopt : challenge(*summary.search.best);
        if (!failing) { // a challenge was drawn for this cycle
            summary.holdsInSample = true;
            return summary;
        }
        search.scenarios.push_back(*failing);
        summary.added.push_back(std::move(*failing));
        search.quickest_us = summary.search.best->time_us; // further scenarios speed nothing up
        if (search.method == SearchMethod::pruned) {
            search.challenge = challenge;
        }
    }
    return summary;
}

std::vector<Project> stockPhases(const Project& project, int phases, double from) {
    std::vector<Project> spread;
    for (const double infeed_mm : infeedsOfStages(project)) {
        for (int i = 0; i < phases && infeed_mm > 0; ++i) {
            spread.push_back(project);
            spread.back().part.stock_mm += infeed_mm * (i + from) / phases;
        }
    }
    return spread;
}

FreshScenarios scenariosAskedFor(const Project& project) {
    const OptimisationScenarios asked = project.optimisation->scenarios;
    if (asked == OptimisationScenarios::nominal || !project.batch) {
        return freshStockPhases;
    }
    return [asked](const Project& best, int round) {
        std::vector<Project> scenarios = freshStockPhases(best, round);
        Project sampled = best;
        if (asked == OptimisationScenarios::corners) {
            sampled.batch->scenarios = Scenarios::corners;
        } else {
            constexpr unsigned mostSeed = std::numeric_limits<int>::max();
            const unsigned seed =
                static_cast<unsigned>(sampled.batch->seed) + static_cast<unsigned>(round);
            sampled.batch->seed = static_cast<int>(seed & mostSeed);
        }
        const ScenarioSource source(std::move(sampled));
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            scenarios.push_back(source.project(part));
        }
        return scenarios;
    };
}

// Multiples of the golden section, without their whole part, fill the unit evenly.
std::vector<Project> freshStockPhases(const Project& best, int round) {
    const double turns = (std::numbers::phi - 1) * round;
    return stockPhases(best, 16, turns - std::floor(turns));
}

} // namespace sparkout
