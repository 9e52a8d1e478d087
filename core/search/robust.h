// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/sampled_phases.h"
#include "core/search/optimise.h"
#include "core/search/phase_cases.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Time against margin: the cycles of a grid for which no other is both as quick and as far from
/// its limits. Margins within equalMargins count as equal.
struct TradeOff {
    std::vector<SearchSummary> cycles; ///< each with a best, the quickest first
    bool isComplete = false;           ///< there are no further cycles
};

/// Computes the trade-off: after the quickest cycle, each next one is the quickest with a greater
/// margin than the last. A feasible cycle X is missing only if one of these is as good in both: let
/// F be the first of them whose margin is not below that of X. X has a greater margin than the one
/// before F, so X was a candidate of the search that found F, and F takes at most as long.
///
/// @param quickest proved, for the same project and options
/// @param options with a proving method; a stop keeps the cycles found so far
[[nodiscard]] TradeOff tradeOff(const Project& project, const SearchSummary& quickest,
                                SearchOptions options, std::size_t most);

/// Returns the scenarios for the test of a cycle in a round, counted from 0: fixed ones, or a fresh
/// sample each time.
using FreshScenarios = std::function<std::vector<Project>(const Project& best, int round)>;

struct RobustOptions {
    SearchOptions search; ///< its scenarios are in the set from the start
    int mostRounds = 50;
    /// Cycles for the machine as it is set, of which the first that passes all tests of an answer
    /// is to be beaten if the project's own is not; those beyond the grid are left out.
    std::vector<Cycle> known{};
};

/// Fresh parts of a batch on which a cycle was tried after those of the batch itself, all of them
/// good.
struct FreshParts {
    int tried = 0;             ///< 0: the search is not for the corners of a batch
    std::optional<double> ppk; ///< lower 95 % bound of the least P_pk, where there is scatter
    bool isCapable = true;     ///< the forecasts of both are within the batch's limits
};

/// Result of a trial on fresh parts.
struct FreshPartsTrial {
    std::optional<Project> bad; ///< a bad part, which ends the trial
    FreshParts good;            ///< otherwise
};

/// The draw of fresh parts for a cycle, from its time alone: every method draws the same.
[[nodiscard]] int freshDraw(std::int64_t time_us);

/// Tries a cycle that is searched for the corners of its batch on the first freshPartCount parts of
/// the batch itself, whose verdict is shown beside the answer, then on as many drawn at random for
/// it. A search for other scenarios is not tried. After a stop the result means nothing.
[[nodiscard]] FreshPartsTrial triedOnFreshParts(const Project& best, int draw,
                                                const std::stop_token& stop = {});

struct RobustSummary {
    SearchSummary search;       ///< summary of the last round
    std::vector<Project> added; ///< scenarios that had to be added
    int rounds = 0;             ///< number of searches made
    long long evaluations = 0;  ///< in all rounds
    long long visits = 0;       ///< in all rounds, without the tests
    bool holdsInSample =
        false; ///< the answer failed in no scenario and no fresh phase of the last round
    std::optional<PhaseCases> decided; ///< cases for each of which the answer is fit
    int freshPhases =
        0; ///< otherwise the number of fresh phases of its last trial, in all of which it was fit
    FreshParts freshParts;    ///< of the answer
    int incapable = 0;        ///< number of cycles rejected for the forecast for their batch alone
    int freshFailures = 0;    ///< number of cycles that failed in a fresh phase or part
    int candidates = 0;       ///< number of cycles tried on fresh phases, each on phases of its own
    int candidate = 0;        ///< number of the answer among them, from 1; 0: not tried
    double nominalTime_s = 0; ///< time of the first round's best; 0: none found
};

/// Optimises, tests the best cycle on the source's scenarios, adds one in which it fails to the set
/// of scenarios, and repeats until none fails [MODEL-8]. The scenario with the greatest violation
/// is added; where draws correspond, they are tried in the order of the last fully tried cycle, the
/// worst first, and the first failing one is added. The answer is the best of the grid for the
/// scenarios in the set. Under gauge control it is the best of the cycles that hold in all of their
/// phaseCases(): this is decided for each cycle that may be the answer, before the source's
/// scenarios and beginning with the cases in which others failed; the failing part is added with
/// its case, and the search continues without the cycles that CaseRefuter refutes for it. Under
/// position control this is not proved: the cycle is tried on random phases of the stock, drawn
/// afresh for each such cycle; the answer failed in none of its own, so that with 95 % confidence
/// at most mostFailing() of the phases fail. A stopped trial counts neither as failed nor as
/// passed. A stop keeps the best cycle so far that passed all of its trials.
///
/// With the corners of a batch, a cycle that holds in all of them is tried by triedOnFreshParts(),
/// because a part between the corners may be bad. A failing part joins the scenarios. A search that
/// proves also rejects a cycle whose fresh parts are all good, but which is not "fit" by weigh():
/// its P_pk or its expected share outside misses the batch's limit. No other cycle is dropped for
/// that. Where all cycles of the grid are so rejected, or the first 50, the answer is the quickest
/// without this requirement, and its FreshParts::isCapable is false.
///
/// Every stage of the answer makes a step on the part itself (SearchOptions::everyStageSteps). A
/// stage that the preceding stage overruns there would be used for other stocks only; a cycle with
/// fewer stages represents it.
///
/// The pruned search is made twice: once for the part, then with the first scenario added. In the
/// second search a cycle that would be the best is first tested on scenarios drawn for it, and a
/// scenario in which it fails joins the set. Every dropped cycle fails in a part of the final set
/// or for a stock of a case, or is slower than a cycle that was the best at that time; as long as
/// that cycle holds in all scenarios that joined later, nothing is lost: cycles with its time are
/// kept waiting, as its margin may fall. Where it does not hold, the search is repeated with the
/// set as it is. Cycles quicker than the best without further scenarios were judged earlier: none
/// of them holds.
///
/// For the greatest margin within a time no scenario is added: the margin of each cycle that would
/// be the best is taken over all parts for which it must hold, which do not depend on the rest of
/// the search: the part, the given scenarios, those of the source's round 0, and under gauge
/// control every stock of its phaseCases(). Under position control it is then tried on fresh phases
/// as above.
[[nodiscard]] RobustSummary optimiseRobustly(const Project& asked, const FreshScenarios& source,
                                             const RobustOptions& options = {});

/// Computes time against margin of a robust search under gauge control: tradeOff() from the
/// quickest feasible cycle, with the margin over all parts for which an answer for the greatest
/// margin must be fit. The result is empty if that cycle is not proved or phases are not decided.
[[nodiscard]] TradeOff tradeOffRobustly(const Project& asked, const FreshScenarios& source,
                                        SearchOptions search, std::size_t most);

/// Returns stock phases that differ from round to round, evenly distributed over many rounds.
[[nodiscard]] std::vector<Project> freshStockPhases(const Project& best, int round);

/// Returns the scenarios of the project's optimisation, each round with fresh stock phases of the
/// part: with `corners` all corners of its batch's factors, with `batch` its batch with another
/// seed each round, with `nominal` only the stock phases. The project's batch must pass
/// checkBatch(). A stop leaves out parts of the batch.
[[nodiscard]] FreshScenarios scenariosAskedFor(const Project& project,
                                               const std::stop_token& stop = {});

/// Returns those scenarios that phaseCases() do not decide: under gauge control only the parts of a
/// batch, since stock phases and corners are among these cases.
[[nodiscard]] FreshScenarios undecidedScenarios(const Project& project,
                                                const std::stop_token& stop = {});

} // namespace sparkout
