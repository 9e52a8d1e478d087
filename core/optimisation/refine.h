// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/robust.h"
#include "core/project/cycle.h"

#include <stop_token>
#include <vector>

/// From a cycle of the grid to a quicker one between its levels.
///
/// 1. Without derivatives (NLopt's Subplex): feeds of all stages and stocks of all but the last,
///    from the given cycle on and then from the best so far, between the least and the greatest
///    level of the grid and within the machine's ranges. What is made small is the time, a little
///    less for what the last step cuts below size, and more for every requirement that breaks, so
///    that there is a slope where the time, a number of steps, has none.
/// 2. Rounded to what the machine can be set to: the steps of its ranges, else three significant
///    digits for a feed; 0.0001 mm of stock. From there, and from the best so far, by such steps in
///    one setting or in a setting and a stock while that helps.
///
/// Every cycle that is tried is run in full by simulateUnchecked(), on the part and in every
/// scenario, and evaluateConstraints() decides on it: the answer holds, and it is the given cycle
/// where no quicker one was met. Nothing is proved: off the grid a still quicker cycle may hold.
namespace sparkout {

struct RefineOptions {
    std::vector<Project> scenarios; ///< in which the cycle must hold, too
    FreshScenarios source;          ///< where given, it must also hold in what this draws and
                                    ///< for every stock, or in fresh phases
    int mostRuns = 4000;            ///< of cycles, in each of at most ten rounds with a source
    bool everyStageSteps = false;   ///< as SearchOptions has it
    int candidates = 0;             ///< cycles that a search tried on fresh phases before
    std::stop_token stop;           ///< what was found so far is the answer; with a source the
                                    ///< given cycle, unless all its scenarios were tried
};

struct RefineSummary {
    Cycle cycle;
    std::int64_t time_us = 0; ///< what it is compared by; 0: stopped before the given one was run
    double time_s = 0;        ///< as simulate() has it; 0 likewise
    double leastRelativeMargin = 0;
    long long runs = 0;     ///< cycles that were run
    bool isQuicker = false; ///< than the one given
    int candidate = 0;      ///< its number among those tried on fresh phases, the search's
                            ///< included; 0: it is the given one, or there is no source
};

/// From a cycle that holds, of a project with a grid. The machine stays as the project has it set,
/// in the scenarios too, and a spark-out keeps its count.
[[nodiscard]] RefineSummary refine(const Project& project, const Cycle& cycle,
                                   const RefineOptions& options = {});

} // namespace sparkout
