// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/interval_search.h"
#include "core/issue.h"
#include "core/optimisation/limit.h"
#include "core/optimisation/optimise.h"
#include "core/optimisation/phase_cases.h"
#include "core/optimisation/variants.h"
#include "core/project/cycle.h"
#include "core/setup/setup.h"
#include "core/setup/surface_wear.h"
#include "core/study/search_levels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

/// The whole search of a project's grid, number of stages by number: the quickest cycle, proved or
/// robust, slower ones farther from their limits, the refinement, and what binds.
namespace sparkout {

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

/// The search of the cycles of one number of stages.
struct SearchedNumber {
    int stages = 0;
    SearchSummary search = {};
    int scenariosAdded = 0;
    double nominalTime_s = 0; ///< of the best one before any was added; 0: none
    bool holds = true; ///< in all scenarios of the last round; what is not robust holds by itself
};

/// All that one search gives: an immutable value. Where it did not run nothing was searched.
struct SearchOutcome {
    Project project; ///< as searched
    GridFault fault = GridFault::none;
    Issues issues;      ///< errors of the project, with which it is not searched
    Issues batchIssues; ///< why the batch that the cycle must hold for cannot be run
    ObjectiveFault objectiveFault = ObjectiveFault::none;
    std::optional<SurfaceWear> wear; ///< for an objective between dressings
    bool robust = false;
    bool refines = false; ///< looked between the levels too
    /// The greatest margin within this time was searched; nothing: the least time.
    std::optional<std::int64_t> marginWithin_us;
    bool isFrontComing = false;     ///< the cycles found by `margin` are still being looked for
    bool isFrontWhole = false;      ///< those found by `margin` are all of the front
    Project searched;               ///< the project with the levels of the last round
    int rounds = 1;                 ///< of SearchLevels
    bool areLevelsCutShort = false; ///< a further round was stopped
    std::vector<LevelEdge> edges;   ///< of its grid that the best of the grid reaches
    std::vector<SearchedNumber> numbers; ///< of stages, as listed; fewer when it was stopped
    /// The best first; those of the front that take longer than the greatest margin may, or that
    /// are of a robust search and not its answer, come last.
    std::vector<FoundCycle> found;
    double limit_s = 0;        ///< of the stepless cycle
    LimitedCycles limitCycles; ///< of which that is
    double bound_s = 0;        ///< no cycle of the grid that holds is quicker; 0: not known
    /// What binds the first of `found`, its time or its margin, whichever is searched; nothing: not
    /// known, as it was stopped before.
    std::optional<std::vector<ConstraintKind>> binding;
    bool stopped = false;

    [[nodiscard]] bool ran() const {
        return fault == GridFault::none && issues.empty() && batchIssues.empty()
               && objectiveFault == ObjectiveFault::none;
    }
    [[nodiscard]] SearchObjective objective() const { return objectiveOf(project); }
    [[nodiscard]] SearchAim aim() const {
        return marginWithin_us ? SearchAim::greatestMargin : SearchAim::leastTime;
    }
    /// Time against margin, the quickest first: those found by `margin`.
    [[nodiscard]] std::vector<const FoundCycle*> front() const;
    [[nodiscard]] const FoundCycle* best() const;    ///< of the grid
    [[nodiscard]] const FoundCycle* refined() const; ///< quicker than the grid's best, if any
    /// The rounds ran out for a number of stages that might have had a quicker cycle.
    [[nodiscard]] bool unresolved() const;
    /// The quickest time [s] of a robust search before scenarios were added; 0: none.
    [[nodiscard]] double nominal_s() const;
    [[nodiscard]] bool proved() const { return best() && !stopped && !unresolved(); }
    /// How often each requirement cut, over all numbers of stages.
    [[nodiscard]] std::array<long long, constraintKinds> cuts() const;
};

using SearchOutcomePtr = std::shared_ptr<const SearchOutcome>;

/// What a search is to do beyond finding the quickest cycle of the grid.
struct SearchWish {
    bool phases = false; ///< hold in every phase of the stock too
    bool refine = false; ///< go on between the levels
    /// That the project is a surface of, for the objectives between dressings; null: none.
    std::shared_ptr<const Setup> setup = {};
    std::size_t surface = 0;
};

/// How far a search is.
struct SearchState {
    FoundBy looksFor = FoundBy::search;
    int stages = 0;                    ///< the number that is searched now
    int round = 1;                     ///< of SearchLevels
    std::optional<double> best_s = {}; ///< quickest so far
    double share = 0;                  ///< of the time given, gone through for the greatest margin
    double bound_s = 0;                ///< no cycle with so many stages is quicker
    long long evaluations = 0;         ///< of these
    double took_s = 0;
};

/// Searches a project's grid in this thread; `note` receives the progress, in any thread. `answer`
/// receives the answer as soon as it stands, before the margins by time are looked for and what is
/// between the levels.
[[nodiscard]] SearchOutcomePtr
runWholeSearch(const Project& project, const SearchWish& wish, std::stop_token stop,
               std::function<void(const SearchState&)> note,
               std::function<void(const SearchOutcomePtr&)> answer = {});

} // namespace sparkout
