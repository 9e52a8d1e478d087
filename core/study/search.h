// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/judgement.h"
#include "core/issue.h"
#include "core/project/cycle.h"
#include "core/search/limit.h"
#include "core/search/optimise.h"
#include "core/search/phase_cases.h"
#include "core/search/refine.h"
#include "core/search/robust.h"
#include "core/search/variants.h"
#include "core/setup/interval_search.h"
#include "core/setup/setup.h"
#include "core/setup/worn_project.h"
#include "core/study/search_levels.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

/// The search of a project's grid, as offered by the window, the command line and Python: the
/// quickest cycle, proved or robust, the requirements that limit it, and on request the refinement
/// between the levels, the best cycle of each number of stages, and slower cycles farther from
/// their limits.
namespace sparkout {

/// Options beyond the best cycle of the grid. If the project requires an answer that is fit for its
/// batch, it is so with any options.
struct SearchWish {
    SearchMethod method = SearchMethod::pruned;
    unsigned threads = 0; ///< threads of the full search; 0: one for each processor
    bool phases = false;  ///< the answer must also be fit for any stock within one infeed
    bool refine = false;  ///< refine the answer between the levels
    bool front = false;   ///< also the best cycle for each number of stages, and margins by time
    /// For the objectives between dressings; not given: the wheel does not wear.
    std::optional<SurfaceWear> wear{};
    SearchJournal* journal = nullptr; ///< journal of an isResumable() search
};

/// Returns whether a stopped search can be resumed by its journal: a full search, but not between
/// dressings, where it consists of many searches.
[[nodiscard]] bool isResumable(const Project& project, SearchMethod method);

/// Returns the wear of one surface of a set-up; empty if it is not given.
[[nodiscard]] std::optional<SurfaceWear> searchWear(const Setup& setup, std::size_t surface);

/// Way in which a search found a cycle.
enum class FoundBy {
    search,    ///< the best when it was found
    margin,    ///< no cycle of the grid is both quicker and farther from its nearest limit
    refinement ///< between the levels of the grid; not proved
};

/// A feasible cycle that a search found.
struct FoundCycle {
    FoundBy by = FoundBy::search;
    Cycle cycle;
    MachineSettings machine; ///< settings with which it is run
    double time_s = 0;
    double leastRelativeMargin = 0;
    bool isBest = false;            ///< best of the whole grid, as far as it was searched
    bool isBestOfItsNumber = false; ///< best with its number of stages
    int candidate = 0; ///< number among the cycles tried on fresh phases, from 1; 0: not tried
    FreshParts freshParts{}; ///< from a search for the corners of a batch
    /// Cases for each of which it is fit, from a robust search under gauge control.
    std::optional<PhaseCases> decided{};
    std::optional<PartsHeld> held{}; ///< from a search between dressings, where the wheel wears
    std::optional<double> cost{};    ///< cost of a part, in the same cases
};

/// Returns the project with the cycle and the machine settings that were found.
[[nodiscard]] Project withFound(Project project, const FoundCycle& found);

/// The best cycle of one number of stages.
struct SearchedNumber {
    int stages = 0;
    SearchStatus status = SearchStatus::infeasible;
    double bound_s = 0;             ///< no cycle with this number of stages is quicker
    std::optional<double> best_s{}; ///< time of the best cycle that is fit everywhere
};

/// The project's own cycle, compared with the one found.
struct GivenCycle {
    bool isStopped = false;       ///< its run was stopped without a result
    std::optional<double> time_s; ///< time, if it ends by itself
    std::optional<double> margin; ///< then the least relative margin of its requirements
    std::vector<ConstraintKind> fails;
};

/// What a simulation of the answer leaves open, and its warnings.
struct AnswerRemarks {
    std::vector<Undecided> notDecided; ///< requirements that the answer may not meet
    /// Requirements that the quickest cycle just meets, with a margin of 0.0 %.
    std::vector<ConstraintKind> noMargin;
    Issues issues; ///< warnings of remarksOn()
    /// Ratio of the wheel's revolutions to the work's, where it is near a whole number: waviness.
    std::optional<double> ratioNearInteger;
};

/// All results of one search, as an immutable value. The search was made only if ran().
struct SearchOutcome {
    Project project; ///< the project searched, with the given cycle
    SearchMethod method = SearchMethod::pruned;
    Issues issues;      ///< errors of the project that prevented the search
    Issues batchIssues; ///< reasons why the batch for which the cycle must be fit cannot be run
    GridFault fault = GridFault::none;
    bool isOtherOperation = false; ///< the method is only for plunge grinding
    bool isOtherAim = false;       ///< the method or the refinement supports only the least time
    ObjectiveFault objectiveFault = ObjectiveFault::none;
    std::optional<SurfaceWear> wear; ///< wear, for an objective between dressings
    /// Time within which the greatest margin was searched; empty: the least time was.
    std::optional<std::int64_t> marginWithin_us;
    bool wishesFront = false;       ///< a front was requested
    bool isFrontComing = false;     ///< the cycles found by `margin` are still being searched
    bool isFrontWhole = false;      ///< the cycles found by `margin` are the complete front
    Project searched;               ///< the project with the levels of the last round
    int rounds = 1;                 ///< number of rounds of SearchLevels
    bool areLevelsCutShort = false; ///< a further round was stopped
    std::vector<LevelEdge> edges;   ///< edges of the grid that its best cycle reaches
    std::vector<SettingEdge> settingEdges; ///< edges of machine settings and spark-out
    SearchSummary search;                  ///< summary of the last round
    std::optional<RobustSummary> robust;   ///< `search` is its last one
    std::optional<IntervalSummary>
        interval; ///< `search` is the one for the answer's number of parts
    std::optional<RefineSummary> refinement;
    std::vector<SearchedNumber>
        numbers; ///< by number of stages, as listed; without a front only the answer's
    /// The answer first, a refined one before the best of the grid; cycles of the front that exceed
    /// the time allowed for the greatest margin, and those of a robust search other than its
    /// answer, are last.
    std::vector<FoundCycle> found;
    SteplessLimit limit;
    /// Requirements that limit the best cycle, its time or its margin, whichever is searched; empty
    /// after a stop, or if no cycle was found.
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
    /// Cycles of time against margin, the quickest first: those found by `margin`.
    [[nodiscard]] std::vector<const FoundCycle*> front() const;
    [[nodiscard]] const FoundCycle* best() const; ///< best of the grid; null if none was found
    [[nodiscard]] const FoundCycle*
    refined() const; ///< refined cycle, quicker than the grid's best; may be null
    [[nodiscard]] const FoundCycle* answer() const; ///< refined, or the best of the grid
    /// Returns whether the rounds ran out before a cycle was found that is fit everywhere.
    [[nodiscard]] bool unresolved() const;
    /// The greatest share of the stocks within one infeed for which the answer of a robust search
    /// may fail, with 95 % confidence; empty if that is decided, or was not required.
    [[nodiscard]] std::optional<double> mostStocksFailing() const;
    /// Returns whether quicker cycles were rejected for the P_pk of their fresh parts, which the
    /// answer has.
    [[nodiscard]] bool isByPpk() const;
    /// The greatest share of the batch's parts that may be rejected, with 95 % confidence.
    [[nodiscard]] std::optional<double> mostPartsBad() const;
    [[nodiscard]] bool proved() const { return best() && search.status == SearchStatus::proved; }
    /// Requirements with the number of their cuts, the most frequent first.
    [[nodiscard]] std::vector<std::pair<ConstraintKind, long long>> cuts() const;
    [[nodiscard]] long long
    evaluations() const;                    ///< number of cycles judged, in all rounds of scenarios
    [[nodiscard]] long long visits() const; ///< number of radii under the wheel in all runs
};

using SearchOutcomePtr = std::shared_ptr<const SearchOutcome>;

/// Progress of a search.
struct SearchState {
    FoundBy looksFor = FoundBy::search;
    int stages = 0;                    ///< number of stages being searched; 0: all
    int round = 1;                     ///< round of SearchLevels
    std::optional<double> best_s = {}; ///< time of the quickest cycle found
    double share =
        0; ///< finished share of the grid (full search), or used share of the time for a margin
    double bound_s = 0;        ///< no cycle being searched is quicker
    long long evaluations = 0; ///< number of cycles judged of these
    double took_s = 0;
};

/// Receivers of the progress of a search, called on any thread.
struct SearchEvents {
    std::function<void(const SearchState&)> note{};
    /// Receives the answer before the front is searched for.
    std::function<void(const SearchOutcomePtr&)> answer{};
};

/// Searches a project's grid in the calling thread. A stop keeps the best so far.
[[nodiscard]] SearchOutcomePtr search(const Project& project, const SearchWish& wish,
                                      std::stop_token stop = {}, SearchEvents events = {});

} // namespace sparkout
