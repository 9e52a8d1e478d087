// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/project/cycle.h"
#include "core/quality/constraints.h"
#include "core/search/variants.h"
#include "core/simulation/result.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

/// Search for the quickest cycle of a project's grid that meets every requirement [MODEL-8].
///
/// Words of the search, in names and comments of this folder:
///
/// * setting: the feeds of a stage, or a spark-out; variant: the machine settings that hold for a
///   whole cycle;
/// * state: everything on which the following steps depend; prefix: the finished stages of a cycle
///   and their state; branch: all cycles with one prefix and next setting;
/// * lag: infeed that a radius has not cut yet, t_П − depth; critical radii: the three by which a
///   last stage is bounded;
/// * bound: a proved least time or number of steps; cut: to end a run that has violated a
///   requirement; refute: to prove that a cycle fails before its last stage is run;
/// * merge: to run one of several cycles with the same passes; label: time and deflection of a
///   state in dynamic programming;
/// * scenario: another state of the part in which a cycle must hold; case: a part and the range of
///   stocks for which it must hold; challenge: a trial on further parts before a cycle becomes the
///   best one.
///
/// A cycle is feasible when it ends by itself and meets every listed requirement, for the part and
/// in every scenario, as simulate() and evaluateConstraints() determine it: the answer rests on no
/// surrogate model. Times are compared in whole microseconds, so that equal times are equal
/// whatever the order in which their seconds were added; among equal times the larger least
/// relative margin wins, then the first variant of machine and spark-out, then the first cycle in
/// grid order. The best cycle of a grid is therefore unique, whatever the method, the number of
/// threads and the order of the search.
///
/// Variants are searched one by one in the order of their least times by TimeBound, each with the
/// best cycle so far as the one to beat: the answer is as exact as the method, since no cycle that
/// could be better is left out.
///
/// Where a greatest time is given (`marginWithin_us`), the answer is instead the cycle with the
/// greatest least relative margin among the feasible ones that take no longer. Margins that differ
/// by no more than equalMargins are equal for a machine setter, and rounding decides which of them
/// is greater. The answer is therefore the quickest, then as above, of the cycles whose margin is
/// within equalMargins of the greatest. It is found in a second search once the greatest margin is
/// proved, because equality in this sense is not transitive and pairwise comparison would not find
/// it. A longer time never gives a margin smaller by more than equalMargins, and with the least
/// time of the grid the answer is that of the search for the least time.

namespace sparkout {

/// Greatest difference of relative margins that count as equal.
inline constexpr double equalMargins = 1e-9;

enum class SearchMethod {
    full,      ///< runs every cycle of the grid from the blank until it is decided
    pruned,    ///< the same proven answer from fewer simulations
    published, ///< heuristic for plunge: dynamic programming by the thesis
    labels,    ///< heuristic for plunge: labels by time and deflection
};

/// Returns whether a method proves nothing.
[[nodiscard]] constexpr bool isHeuristic(SearchMethod method) {
    return method == SearchMethod::published || method == SearchMethod::labels;
}

/// A feasible cycle of the grid and the values by which it is compared.
struct FeasibleCycle {
    GridCycle cycle;
    std::int64_t time_us = 0; ///< rounded for comparison
    double leastRelativeMargin = 0;
    std::size_t variant = 0; ///< index in Variants
    double time_s = 0;       ///< unrounded, from simulate(): the time reported
};

/// Criterion by which one feasible cycle is better than another.
enum class SearchAim {
    leastTime,     ///< then the greater margin
    greatestMargin ///< within a time; then the quicker
};

/// Margin of a cycle on further parts.
struct WholeMargin {
    std::optional<double> margin; ///< least relative margin; empty: the cycle fails on a part or
                                  ///< has less than required
};

/// Point at which a full search was stopped and can be resumed.
struct SearchCheckpoint {
    GridCycle last; ///< last judged cycle, after all those before it; empty if none was judged
    std::optional<FeasibleCycle> best;
    std::size_t variant = 0; ///< the variant being searched
    /// Counts up to this point, as in the summary.
    long long evaluations = 0, visits = 0;
    std::array<long long, constraintKinds> cuts{};
};

/// A part for which a cycle must be fit with any stock from the least to the greatest of `stocks`,
/// extended on both sides by half the largest infeed of the cycle.
struct PhaseCase {
    std::int64_t corner = -1; ///< number of the corner; −1: the nominal part
    Project part;
    StockRange stocks; ///< per side
};

/// A part on which a cycle fails; none where it is rejected for its batch as a whole.
struct FailingPart {
    std::optional<Project> part;
    std::optional<PhaseCase> of; ///< the case to which it belongs
};

struct SearchProgress {
    std::optional<FeasibleCycle> best; ///< the best found
    double bound_s = 0;                ///< no feasible cycle is quicker than both this and the best
    long long evaluations = 0;         ///< cycles decided on one by one
    double share = 0; ///< full search: finished share of the grid; search for the greatest margin:
                      ///< share of the given time
    std::optional<SearchCheckpoint> checkpoint = {}; ///< full search: point at which to resume
};

class SearchJournal; // core/search/search_journal.h

struct SearchOptions {
    SearchMethod method = SearchMethod::pruned;
    unsigned threads = 0; ///< threads of the full search; 0: one for each processor
    /// Approximate memory of the pruned search; with less, more is computed twice, and the order of
    /// the branches changes, but never the answer.
    std::size_t memory_bytes = std::size_t{1} << 28;
    /// Other states of the part in which the cycle must be fit, as projects whose cycles are
    /// replaced.
    std::vector<Project> scenarios;
    std::optional<SearchCheckpoint> resume;                ///< full search
    std::function<void(const SearchProgress&)> onProgress; ///< called by one thread at a time
    std::stop_token stop;
    /// Least relative margin that a cycle must exceed; not given: every feasible cycle is accepted.
    std::optional<double> beyondMargin;
    std::optional<FeasibleCycle> incumbent; ///< a feasible cycle to be beaten
    std::size_t variant = 0;                ///< set by optimise(): the variant being searched
    /// Parts for which the cycle must be fit with any stock. The pruned search drops the cycles
    /// that CaseRefuter refutes; the others are not tried on these parts.
    std::vector<PhaseCase> cases;
    /// Pruned search: returns why a cycle that would be the best is rejected, or nullopt. A part on
    /// which it fails joins the scenarios, its case the cases.
    std::function<std::optional<FailingPart>(const FeasibleCycle&)> challenge;
    std::vector<FeasibleCycle> rejected; ///< cycles that are no answer although they are feasible
    std::int64_t quickest_us = 0;        ///< proved earlier: no feasible cycle is quicker
    /// Rejects a cycle with a stage that makes no step on the part since size is reached before it:
    /// it is one with fewer stages.
    bool everyStageSteps = false;
    /// Time within which the greatest margin is searched for; only with proving methods and without
    /// a challenge.
    std::optional<std::int64_t> marginWithin_us;
    /// Returns the margin on further parts of a cycle that would be the best, which must be at
    /// least `least`. The result must not depend on other cycles. Requires that there is no
    /// challenge.
    std::function<WholeMargin(const FeasibleCycle&, double least)> wholeMargin;
    /// Full search: records the progress and supplies that of earlier runs.
    SearchJournal* journal = nullptr;

    [[nodiscard]] SearchAim aim() const {
        return marginWithin_us ? SearchAim::greatestMargin : SearchAim::leastTime;
    }
};

enum class SearchStatus {
    proved,     ///< the best cycle of the grid
    infeasible, ///< no cycle of the grid is feasible
    stopped,    ///< stopped on request: best so far and bound
    found,      ///< found by a heuristic: feasible, but a quicker one may exist
    notFound,   ///< no cycle found by a heuristic: one may exist
};

struct SearchSummary {
    SearchStatus status = SearchStatus::infeasible;
    std::optional<FeasibleCycle> best;
    Cycle cycle;             ///< the best cycle in the form of a project
    MachineSettings machine; ///< machine settings of that cycle
    /// No feasible cycle of the grid is quicker; 0: unknown, as for heuristics and in a search for
    /// the greatest margin.
    double bound_s = 0;
    std::int64_t gridSize = 0; ///< cycles in the grid
    long long evaluations = 0; ///< cycles decided on one by one
    long long visits = 0;      ///< radii under the wheel in all runs
    /// Number of cuts by each kind of requirement: a cycle counts for each that it violates, but
    /// only for its diameters where they miss the tolerance; a branch dropped at a pass counts
    /// once.
    std::array<long long, constraintKinds> cuts{};
    SearchCheckpoint checkpoint;       ///< full search
    std::vector<Project> added;        ///< scenarios that challenges added
    std::vector<PhaseCase> addedCases; ///< cases that challenges added
    /// A best cycle failed in a scenario that was added later, and a cycle cut because of it may be
    /// the best. The search was ended and must be repeated with the added scenarios.
    bool isStale = false;
};

/// Returns the greatest time that the project's search for the greatest margin allows, in whole
/// microseconds; nullopt if it searches for the least time.
[[nodiscard]] std::optional<std::int64_t> marginWithinOf(const Project& project);

/// Searches the grid of a valid project; an empty grid is infeasible. The options determine the aim
/// of the search, not the project.
[[nodiscard]] SearchSummary optimise(const Project& project, const SearchOptions& options = {});

/// Makes one of the searches of optimise(), for the greatest margin the first of the two, without a
/// journal.
[[nodiscard]] SearchSummary searchVariants(const Project& project, const SearchOptions& options);

/// Returns the project with the best cycle and its machine settings; the summary must have a best
/// cycle.
[[nodiscard]] Project withBest(Project project, const SearchSummary& summary);

// Names of the methods and outcomes of a search in `--method` and `--json`.

[[nodiscard]] const char* searchMethodName(SearchMethod method);
[[nodiscard]] std::optional<SearchMethod> searchMethodNamed(std::string_view name);
[[nodiscard]] const char* searchStatusName(SearchStatus status);

} // namespace sparkout
