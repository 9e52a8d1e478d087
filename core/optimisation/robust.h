// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"
#include "core/optimisation/phase_cases.h"
#include "core/optimisation/trade_off.h"
#include "core/phases/sampled_phases.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// The scenarios to test a cycle on in a round, from 0: fixed ones, or a fresh sample each time.
using FreshScenarios = std::function<std::vector<Project>(const Project& best, int round)>;

struct RobustOptions {
    SearchOptions search; ///< its scenarios are in the set from the beginning
    int mostRounds = 50;
};

struct RobustSummary {
    SearchSummary search;              ///< of the last round
    std::vector<Project> added;        ///< the scenarios that had to be added
    int rounds = 0;                    ///< searches made
    long long evaluations = 0;         ///< of all rounds
    long long visits = 0;              ///< of all rounds, without the tests
    bool holdsInSample = false;        ///< none of the last round's scenarios failed, nor of
                                       ///< the fresh phases
    std::optional<PhaseCases> decided; ///< cases for each of which the answer holds
    int freshPhases = 0;               ///< else those that it was tried on at last, and held in all
    int freshParts = 0;                ///< of a batch whose corners are searched: likewise
    int freshFailures = 0;             ///< cycles that failed in one of theirs; it was added
    int candidates = 0;                ///< cycles that were tried on fresh phases, each on its own
    int candidate = 0;                 ///< the answer's number among them, from 1; 0: none
    double nominalTime_s = 0;          ///< of the first round's best; 0: none
};

/// Optimises, tests the best cycle on the source's scenarios, adds one in which it fails to those
/// it must hold in, and again, until none fails [MODEL-8]. Added is the one that fails by most;
/// where draws correspond they are tried in the order of the last cycle that was tried on all, the
/// worst first, and added is the first that fails. The answer is the best of the grid for the
/// scenarios in the set. Under gauge control it is the best of those that hold in all of their
/// phaseCases(): this is decided for each cycle that may be the answer, before the source's
/// scenarios the cases in which others failed; the part that fails is added, with its case, and the
/// search goes on without what PhaseOutlook shows to fail there. Under position control that is
/// not proved: it is tried on phases of the stock drawn at random, fresh for each such cycle; the
/// answer is one that failed in none of its own, so that with 95 % confidence no more than
/// mostFailing() of the phases fail. A stop leaves a trial unchecked: it counts neither as one that
/// failed nor as one that held. What it keeps is the best so far that came through all of its own.
///
/// With the corners of a batch a cycle that holds in all of them is tried on the first
/// freshPartCount parts of the batch itself, then on as many drawn at random, afresh for each:
/// between the corners a part may be bad. One that fails joins the scenarios.
///
/// Every stage of the answer makes a step on the part itself (SearchOptions::everyStageSteps). A
/// stage that the stage before overruns there would be in use for other stocks only; a cycle with
/// fewer stages stands for it.
///
/// The pruned search is made twice: once for the part, then with the first scenario added. There
/// a cycle that would be the best is tested before it counts, on scenarios drawn for it, and what
/// it fails in joins the set. What was dropped before failed in a part of the final set, or for a
/// stock of a case, or is slower than a cycle that was the best then; as long as that one holds in
/// all scenarios that joined later, nothing is lost: cycles of its time are not dropped, they wait,
/// as its margin may fall. Where it does not hold, the search is made again with the set as it is.
/// Cycles quicker than the best without further scenarios were judged before: none of them holds.
///
/// For the greatest margin within a time no scenario is added: the margin of each cycle that would
/// be the best is taken on all that it must hold for, which is the same whatever else is searched:
/// the part, the scenarios given, those of the source's round 0, and under gauge control every
/// stock of its phaseCases(). Under position control it is then tried on fresh phases as above.
[[nodiscard]] RobustSummary optimiseRobustly(const Project& asked, const FreshScenarios& source,
                                             const RobustOptions& options = {});

/// Time against margin of a robust search under gauge control: tradeOff() with the margin on all
/// that an answer for the greatest margin must hold for, from the quickest cycle that holds there.
/// None where that is not proved, or phases are not decided.
[[nodiscard]] TradeOff tradeOffRobustly(const Project& asked, const FreshScenarios& source,
                                        SearchOptions search, std::size_t most);

/// Stock phases that differ from round to round, evenly over many rounds.
[[nodiscard]] std::vector<Project> freshStockPhases(const Project& best, int round);

/// The scenarios that the project's optimisation asks for, each round with fresh stock phases of
/// the part: with `corners` all corners of its batch's factors, with `batch` its batch with another
/// seed each round. Of a project whose batch checkBatch() passes; with `nominal` the stock phases
/// alone. A stop leaves out parts of the batch.
[[nodiscard]] FreshScenarios scenariosAskedFor(const Project& project,
                                               const std::stop_token& stop = {});

/// Those of them that phaseCases() do not decide: under gauge control the parts of a batch alone,
/// for the stock phases and the corners are among these cases.
[[nodiscard]] FreshScenarios undecidedScenarios(const Project& project,
                                                const std::stop_token& stop = {});

} // namespace sparkout
