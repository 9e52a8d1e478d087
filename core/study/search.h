// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/interval_search.h"
#include "core/issue.h"
#include "core/optimisation/limit.h"
#include "core/optimisation/optimise.h"
#include "core/optimisation/phase_cases.h"
#include "core/optimisation/refine.h"
#include "core/optimisation/robust.h"
#include "core/optimisation/variants.h"
#include "core/project/cycle.h"
#include "core/setup/setup.h"
#include "core/setup/surface_wear.h"
#include "core/study/search_levels.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

/// The search of a project's grid, as the window, the command line and Python ask for it: the
/// quickest cycle, proved or robust, what binds it, and on request the refinement between the
/// levels, the best cycle of each number of stages, and slower ones farther from their limits.
namespace sparkout {

/// What a search is to do beyond finding the best cycle of the grid. An answer that the project
/// asks to hold for its batch does so whatever is wished.
struct SearchWish {
    SearchMethod method = SearchMethod::pruned;
    unsigned threads = 0; ///< of the full search; 0: as many as the machine has
    bool phases = false;  ///< the answer holds in every phase of the stock too
    bool refine = false;  ///< goes on between the levels
    bool front = false;   ///< the best of each number of stages too, and margins by time
    /// For the objectives between dressings; not given: the wheel does not wear.
    std::optional<SurfaceWear> wear{};
    SearchJournal* journal = nullptr; ///< of a search that isResumable()
};

/// Whether a search that was stopped can be gone on with by its journal: a full one, and not
/// between dressings, where it is many.
[[nodiscard]] bool isResumable(const Project& project, SearchMethod method);

/// The wear of one surface of a set-up; nothing: it is not stated.
[[nodiscard]] std::optional<SurfaceWear> searchWear(const Setup& setup, std::size_t surface);

/// How a search came upon a cycle.
enum class FoundBy {
    search,    ///< it was the best so far
    margin,    ///< none of the grid is both quicker and farther from its nearest limit
    refinement ///< between the levels of the grid; not proved
};

/// A feasible cycle that a search came upon.
struct FoundCycle {
    FoundBy by = FoundBy::search;
    Cycle cycle;
    MachineSettings machine; ///< that it is run with
    double time_s = 0;
    double leastRelativeMargin = 0;
    bool isBest = false;            ///< of the whole grid, as far as it was searched
    bool isBestOfItsNumber = false; ///< of stages
    int candidate = 0; ///< its number among those tried on fresh phases, from 1; 0: not tried
    /// Of a robust search under gauge control the cases for each of which it holds.
    std::optional<PhaseCases> decided{};
    std::optional<PartsHeld> held{}; ///< of a search between dressings, where the wheel wears
    std::optional<double> cost{};    ///< of a part, there too
};

/// A project with the cycle and the machine's settings that were found.
[[nodiscard]] Project withFound(Project project, const FoundCycle& found);

/// The best cycle of one number of stages.
struct SearchedNumber {
    int stages = 0;
    SearchStatus status = SearchStatus::infeasible;
    double bound_s = 0;             ///< no cycle with so many stages is quicker
    std::optional<double> best_s{}; ///< of one that holds in all that it must
};

/// The project's own cycle, beside the one found.
struct GivenCycle {
    bool isStopped = false;       ///< before its end: nothing is known of it
    std::optional<double> time_s; ///< when it ends by itself
    std::vector<ConstraintKind> fails;
};

/// What simulating the answer would remark.
struct AnswerRemarks {
    Issues issues; ///< warnings of remarksOn()
    /// Of the wheel's revolutions to the work's, where it is near a whole number: waviness.
    std::optional<double> ratioNearInteger;
};

/// All that one search gives: an immutable value. Where it did not run nothing was searched.
struct SearchOutcome {
    Project project; ///< as searched: the given cycle
    SearchMethod method = SearchMethod::pruned;
    Issues issues;      ///< errors of the project, with which it is not searched
    Issues batchIssues; ///< why the batch that the cycle must hold for cannot be run
    GridFault fault = GridFault::none;
    bool isOtherOperation = false; ///< the method is for plunge grinding alone
    bool isOtherAim = false; ///< the method, or the refinement, looks for the least time alone
    ObjectiveFault objectiveFault = ObjectiveFault::none;
    std::optional<SurfaceWear> wear; ///< for an objective between dressings
    /// The greatest margin within this time was searched; nothing: the least time.
    std::optional<std::int64_t> marginWithin_us;
    bool wishesFront = false;       ///< beyond its answer
    bool isFrontComing = false;     ///< the cycles found by `margin` are still being looked for
    bool isFrontWhole = false;      ///< those found by `margin` are all of the front
    Project searched;               ///< the project with the levels of the last round
    int rounds = 1;                 ///< of SearchLevels
    bool areLevelsCutShort = false; ///< a further round was stopped
    std::vector<LevelEdge> edges;   ///< of its grid that the best of the grid reaches
    std::vector<SettingEdge> settingEdges;   ///< the same of the machine's settings and spark-out
    SearchSummary search;                    ///< of the last round
    std::optional<RobustSummary> robust;     ///< of which the search is the last
    std::optional<IntervalSummary> interval; ///< of which it is that for the answer's parts
    std::optional<RefineSummary> refinement;
    std::vector<SearchedNumber> numbers; ///< of stages, as listed; without a front the answer's
    /// The answer first, a refined one before the best of the grid; those of the front that take
    /// longer than the greatest margin may, or that are of a robust search and not its answer, come
    /// last.
    std::vector<FoundCycle> found;
    SteplessLimit limit;
    /// What binds the best of the search, its time or its margin, whichever is searched; nothing:
    /// not known, as it was stopped before, or no cycle was found.
    std::optional<std::vector<ConstraintKind>> binding;
    GivenCycle given;
    AnswerRemarks remarks;

    [[nodiscard]] bool ran() const {
        return issues.empty() && batchIssues.empty() && fault == GridFault::none
               && !isOtherOperation && !isOtherAim && objectiveFault == ObjectiveFault::none;
    }
    [[nodiscard]] bool stopped() const { return search.status == SearchStatus::stopped; }
    [[nodiscard]] SearchObjective objective() const { return objectiveOf(project); }
    [[nodiscard]] SearchAim aim() const {
        return marginWithin_us ? SearchAim::greatestMargin : SearchAim::leastTime;
    }
    /// Time against margin, the quickest first: those found by `margin`.
    [[nodiscard]] std::vector<const FoundCycle*> front() const;
    [[nodiscard]] const FoundCycle* best() const;    ///< of the grid; null: none was found
    [[nodiscard]] const FoundCycle* refined() const; ///< quicker than the grid's best, if any
    [[nodiscard]] const FoundCycle* answer() const;  ///< refined, or the best of the grid
    /// The rounds ran out before a cycle was found that holds in all that it must.
    [[nodiscard]] bool unresolved() const;
    /// The share of the stocks within one infeed that the answer of a robust search may fail for,
    /// at most, with 95 % confidence; nothing: that is decided, or was not asked.
    [[nodiscard]] std::optional<double> mostStocksFailing() const;
    /// Likewise of the parts of the batch that may be bad.
    [[nodiscard]] std::optional<double> mostPartsBad() const;
    [[nodiscard]] bool proved() const { return best() && search.status == SearchStatus::proved; }
    /// What cut, the most frequent first.
    [[nodiscard]] std::vector<std::pair<ConstraintKind, long long>> cuts() const;
    [[nodiscard]] long long evaluations() const; ///< cycles judged, in all rounds of scenarios
    [[nodiscard]] long long visits() const;      ///< radii under the wheel, likewise
};

using SearchOutcomePtr = std::shared_ptr<const SearchOutcome>;

/// How far a search is.
struct SearchState {
    FoundBy looksFor = FoundBy::search;
    int stages = 0;                    ///< the number that is searched now; 0: all
    int round = 1;                     ///< of SearchLevels
    std::optional<double> best_s = {}; ///< quickest so far
    double share = 0;          ///< of the grid, full search, or of the time given for a margin
    double bound_s = 0;        ///< no cycle of those that are searched now is quicker
    long long evaluations = 0; ///< of these
    double took_s = 0;
};

/// Whom a search keeps informed, in any thread.
struct SearchEvents {
    std::function<void(const SearchState&)> note{};
    /// The answer as soon as it stands, before the front is looked for.
    std::function<void(const SearchOutcomePtr&)> answer{};
};

/// Searches a project's grid in this thread. A stop keeps the best so far.
[[nodiscard]] SearchOutcomePtr search(const Project& project, const SearchWish& wish,
                                      std::stop_token stop = {}, SearchEvents events = {});

} // namespace sparkout
