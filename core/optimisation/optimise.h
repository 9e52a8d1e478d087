// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/variants.h"
#include "core/phases/phase_decision.h"
#include "core/project/cycle.h"
#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// The quickest cycle of a project's grid that holds every requirement [MODEL-8].
///
/// A cycle is feasible when it ends by itself and, for the part and in every scenario, every
/// listed requirement holds, as simulate() and evaluateConstraints() find it: no surrogate takes
/// part in the answer. Times are compared in whole microseconds, so that equal times are equal
/// however their seconds were added up; among equal times the larger least relative margin wins,
/// then the first of the variants of machine and spark-out, then the first in grid order. The best
/// of a grid is thus one cycle, whatever the method, the number of threads and the order of the
/// search.
///
/// Variants are searched one by one, those first whose least time, by TimeBound, is the least, each
/// with the best of those before to beat: as exact as the method is, since none that could beat it
/// is left out.
///
/// Or, where a most time is given (`marginWithin_us`), the cycle of the greatest least relative
/// margin among those that hold and take no longer. Margins that differ by no more than
/// equalMargins are one and the same to whoever sets the machine, and which of them is the greater
/// is a matter of last bits. So the answer is the quickest, then as above, of the cycles whose
/// margin is within equalMargins of the greatest: it is looked for in a search of its own once the
/// greatest is proved, for "equal" in this sense is not transitive, and no comparison of two cycles
/// after another finds it. A longer time never has a smaller margin by more than that, and with the
/// least time of the grid the answer is that of the search for it.
namespace sparkout {

/// Relative margins that differ by no more count as equal.
inline constexpr double equalMargins = 1e-9;

enum class SearchMethod {
    full,      ///< runs every cycle of the grid from the blank, until it is decided
    pruned,    ///< the same answer, proven, from fewer simulations
    published, ///< heuristic for plunge: dynamic programming as the thesis has it
    labels,    ///< heuristic for plunge: labels by time and deflection
};

/// Whether what a method finds is proved by nothing.
[[nodiscard]] constexpr bool isHeuristic(SearchMethod method) {
    return method == SearchMethod::published || method == SearchMethod::labels;
}

/// A feasible cycle of the grid and what it is compared by.
struct FeasibleCycle {
    GridCycle cycle;
    std::int64_t time_us = 0; ///< what it is compared by
    double leastRelativeMargin = 0;
    std::size_t variant = 0; ///< of Variants
    double time_s = 0;       ///< to the last bit, as simulate() has it: what is stated
};

/// What makes one feasible cycle better than another.
enum class SearchAim {
    leastTime,     ///< then the greater margin
    greatestMargin ///< within a time; then the quicker
};

/// The margin of a cycle on further parts.
struct WholeMargin {
    std::optional<double> margin; ///< least relative; nothing: it fails on one, or has less there
};

/// Where a full search was stopped, to go on from.
struct SearchCheckpoint {
    GridCycle last; ///< the last cycle that was judged, all before it too; empty: none
    std::optional<FeasibleCycle> best;
    std::size_t variant = 0; ///< that was searched
    /// What was counted up to there, as the summary has it.
    long long evaluations = 0, visits = 0;
    std::array<long long, constraintKinds> cuts{};
};

/// A part for which a cycle has to hold whatever its stock: from the least of `stocks` to the
/// greatest, and half the largest infeed of the cycle beyond either.
struct PhaseCase {
    std::int64_t corner = -1; ///< by which it is known; −1: the part as it stands
    Project part;
    StockRange stocks; ///< per side
};

/// A part on which a cycle fails.
struct FailingPart {
    Project part;
    std::optional<PhaseCase> of; ///< the case it is one of
};

struct SearchProgress {
    std::optional<FeasibleCycle> best; ///< so far
    double bound_s = 0;                ///< no feasible cycle is quicker than this and the best
    long long evaluations = 0;         ///< cycles decided on one by one
    double share = 0; ///< of the grid done, full search; for the greatest margin of the time given
    std::optional<SearchCheckpoint> checkpoint = {}; ///< full search: to go on from here
};

class SearchJournal; // core/optimisation/search_journal.h

struct SearchOptions {
    SearchMethod method = SearchMethod::pruned;
    unsigned threads = 0; ///< of the full search; 0: as many as the machine has
    /// The pruned search's, about; with less of it more is computed twice, and in the end the order
    /// of its branches, never its answer, is another.
    std::size_t memory_bytes = std::size_t{1} << 28;
    /// The part's other states in which the cycle must hold: projects whose cycles are replaced.
    std::vector<Project> scenarios;
    std::optional<SearchCheckpoint> resume;                ///< full search
    std::function<void(const SearchProgress&)> onProgress; ///< by one thread at a time
    std::stop_token stop;
    /// Only cycles whose least relative margin is greater are looked for; not given: all that hold.
    std::optional<double> beyondMargin;
    std::optional<FeasibleCycle> incumbent; ///< a cycle that holds, to be beaten
    std::size_t variant = 0;                ///< by optimise(): the one that is searched
    /// Parts in which the cycle must hold whatever their stock. The pruned search drops cycles that
    /// PhaseOutlook shows to fail; the others are not tried on them.
    std::vector<PhaseCase> cases;
    /// Pruned search: a further part on which a cycle fails that would be the best, or nothing. The
    /// part joins the scenarios, its case the cases.
    std::function<std::optional<FailingPart>(const FeasibleCycle&)> challenge;
    std::int64_t quickest_us = 0; ///< no cycle that holds is quicker, as was proved before
    /// A cycle of which a stage makes no step on the part, as the size is reached before, does not
    /// count: it is one with fewer stages.
    bool everyStageSteps = false;
    /// The greatest margin of the cycles that take no longer is looked for. Of methods that prove,
    /// without a challenge.
    std::optional<std::int64_t> marginWithin_us;
    /// Of a cycle that would be the best its margin on further parts, to be no less than the one
    /// given. What it says of a cycle must not depend on the others. Without a challenge.
    std::function<WholeMargin(const FeasibleCycle&, double least)> wholeMargin;
    /// Full search: keeps what was searched, and knows what was searched before.
    SearchJournal* journal = nullptr;

    [[nodiscard]] SearchAim aim() const {
        return marginWithin_us ? SearchAim::greatestMargin : SearchAim::leastTime;
    }
};

enum class SearchStatus {
    proved,     ///< the best cycle of the grid
    infeasible, ///< no cycle of the grid is feasible
    stopped,    ///< on request: best so far and bound
    found,      ///< by a heuristic: holds, but a quicker one may hold too
    notFound,   ///< by a heuristic: there may be one
};

struct SearchSummary {
    SearchStatus status = SearchStatus::infeasible;
    std::optional<FeasibleCycle> best;
    Cycle cycle;             ///< the best one, as a project states it
    MachineSettings machine; ///< that it is run with
    /// No cycle of the grid that holds is quicker; 0: not known, as of heuristics and where the
    /// greatest margin is looked for.
    double bound_s = 0;
    std::int64_t gridSize = 0; ///< cycles in the grid
    long long evaluations = 0; ///< cycles decided on one by one
    long long visits = 0;      ///< radii under the wheel, of all runs
    /// How often each requirement cut, by kind: a cycle counts for each it breaks, but for its
    /// diameters alone where they miss the field; a branch that was dropped at a pass once.
    std::array<long long, constraintKinds> cuts{};
    SearchCheckpoint checkpoint;       ///< full search
    std::vector<Project> added;        ///< the scenarios of challenges
    std::vector<PhaseCase> addedCases; ///< and their cases
    /// A best cycle failed in a scenario that was added later; what it cut off may be the best. The
    /// search was stopped, and must be made again with the scenarios added.
    bool isStale = false;
};

/// The most time that the project's search for the greatest margin leaves a cycle, in whole
/// microseconds; nothing: the least time is looked for.
[[nodiscard]] std::optional<std::int64_t> marginWithinOf(const Project& project);

/// Searches the grid of a valid project. An empty grid is infeasible. What the project's search
/// aims at does not count here, but what the options do.
[[nodiscard]] SearchSummary optimise(const Project& project, const SearchOptions& options = {});

/// One search of those that optimise() makes: for the greatest margin the first of its two. Without
/// a journal.
[[nodiscard]] SearchSummary searchVariants(const Project& project, const SearchOptions& options);

/// The project with the best cycle and its machine in place; a summary with a best.
[[nodiscard]] Project withBest(Project project, const SearchSummary& summary);

} // namespace sparkout
