// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <functional>
#include <vector>

namespace sparkout {

/// The scenarios to test a cycle on in a round, from 0: fixed ones, or a fresh sample each time.
using FreshScenarios = std::function<std::vector<Project>(const Project& best, int round)>;

struct RobustOptions {
    SearchOptions search; ///< its scenarios are in the set from the beginning
    int mostRounds = 50;
};

struct RobustSummary {
    SearchSummary search;            ///< of the last round
    std::vector<Project> added;      ///< the scenarios that had to be added
    int rounds = 0;                  ///< searches made
    long long evaluations = 0;       ///< of all rounds
    long long visits = 0;            ///< of all rounds, without the tests
    bool holdsInSample = false;      ///< none of the last round's scenarios failed
    std::int64_t nominalTime_us = 0; ///< of the first round's best; 0: none
};

/// Optimises, tests the best cycle on the source's scenarios, adds one in which it fails to those
/// it must hold in, and again, until none fails [MODEL-8]. Added is the one that fails by most;
/// where draws correspond they are tried in the order of the last cycle that was tried on all, the
/// worst first, and added is the first that fails. The answer is the best of the grid for the
/// scenarios in the set; that it holds in others is shown for the last sample alone.
///
/// The pruned search is made twice: once for the part, then with the first scenario added. There
/// a cycle that would be the best is tested before it counts, on scenarios drawn for it, and what
/// it fails in joins the set. What was dropped before failed in a part of the final set or is
/// slower than a cycle that was the best then; as long as that one holds in all scenarios that
/// joined later, nothing is lost: cycles of its time are not dropped, they wait, as its margin may
/// fall. Where it does not hold, the search is made again with the set as it is. Cycles quicker
/// than the best without further scenarios were judged before: none of them holds.
[[nodiscard]] RobustSummary optimiseRobustly(const Project& project, const FreshScenarios& source,
                                             const RobustOptions& options = {});

/// The project with stocks spread evenly over one infeed of each stage of its cycle, `phases` a
/// stage, from a share of a phase on: where the last step falls decides on the size, and corners
/// alone miss it.
[[nodiscard]] std::vector<Project> stockPhases(const Project& project, int phases = 16,
                                               double from = 0);

/// Stock phases that differ from round to round, evenly over many rounds.
[[nodiscard]] std::vector<Project> freshStockPhases(const Project& best, int round);

/// The scenarios that the project's optimisation asks for, each round with fresh stock phases of
/// the part: with `corners` all corners of its batch's factors, with `batch` its batch with another
/// seed each round. Of a project whose batch checkBatch() passes; with `nominal` the stock phases
/// alone.
[[nodiscard]] FreshScenarios scenariosAskedFor(const Project& project);

} // namespace sparkout
