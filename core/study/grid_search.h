// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/interval_search.h"
#include "core/issue.h"
#include "core/optimisation/limit.h"
#include "core/optimisation/optimise.h"
#include "core/optimisation/refine.h"
#include "core/optimisation/robust.h"
#include "core/setup/surface_wear.h"
#include "core/study/search_levels.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// The search of a whole grid at once by any method, with what its answer is to be read with.
namespace sparkout {

struct GridSearchOptions {
    SearchMethod method = SearchMethod::pruned;
    unsigned threads = 0; ///< of the full search; 0: as many as the machine has
    /// The answer must hold in every phase of the stock too. One that the project asks to hold for
    /// its batch does so whatever is wished.
    bool robust = false;
    bool refine = false; ///< go on off the grid
    /// For the objectives between dressings; not given: the wheel does not wear.
    std::optional<SurfaceWear> wear;
    std::function<void(const SearchProgress&)> onProgress;
    SearchJournal* journal = nullptr; ///< of the full search
    std::stop_token stop;
};

/// The project's own cycle, beside the one found.
struct GivenCycle {
    bool isStopped = false;       ///< before its end: nothing is known of it
    std::optional<double> time_s; ///< when it ends by itself
    std::vector<ConstraintKind> fails;
};

/// A search and what its answer is to be read with.
struct GridSearchReport {
    Project project; ///< as read: the given cycle
    SearchMethod method = SearchMethod::pruned;
    Issues issues;                     ///< errors of the project, or why its batch cannot be run
    GridFault fault = GridFault::none; ///< why its grid cannot be searched
    bool isOtherOperation = false;     ///< the method is for plunge grinding alone
    bool isOtherAim = false; ///< the method, or the refinement, looks for the least time alone
    ObjectiveFault objectiveFault = ObjectiveFault::none;
    Project searched;               ///< the project with the levels of the last round
    int rounds = 1;                 ///< of SearchLevels
    bool areLevelsCutShort = false; ///< a further round was stopped
    std::vector<LevelEdge> edges;   ///< of its grid that the answer of the grid reaches
    SearchSummary search;
    std::optional<RobustSummary> robust;     ///< of which the search is the last
    std::optional<IntervalSummary> interval; ///< of which it is that for the answer's parts
    std::optional<RefineSummary> refined;
    double limit_s = 0;  ///< stepless
    SteplessLimit limit; ///< the same, with what makes it
    /// What keeps the answer from being quicker, or of its margin from being greater; nothing: not
    /// known, or no cycle.
    std::optional<std::vector<ConstraintKind>> binding;
    std::optional<std::int64_t> marginWithin_us; ///< what it is the greatest margin within
    GivenCycle given;

    /// Else nothing was searched.
    [[nodiscard]] bool ran() const {
        return issues.empty() && fault == GridFault::none && !isOtherOperation && !isOtherAim
               && objectiveFault == ObjectiveFault::none;
    }
};

/// Searches the grid of a project. A stop keeps the best so far.
[[nodiscard]] GridSearchReport searchGrid(const Project& project, const GridSearchOptions& options);

/// Whether the answer was found off the grid, by refinement.
[[nodiscard]] bool isRefined(const GridSearchReport& report);

/// Whether there is a cycle to give: feasible, and tested where it must be robust.
[[nodiscard]] bool hasAnswer(const GridSearchReport& report);

/// The cycle to give: refined, or the best of the grid.
[[nodiscard]] const Cycle& cycleFound(const GridSearchReport& report);
/// The project with that cycle and its machine.
[[nodiscard]] Project withAnswer(const GridSearchReport& report);

} // namespace sparkout
