// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/project.h"
#include "core/search/robust.h"

#include <optional>
#include <stop_token>
#include <vector>

/// Refinement of a cycle of the grid to a quicker one between its levels.
///
/// 1. A search without derivatives (NLopt's Subplex) varies the feeds of all stages and the stocks
///    of all but the last, from the given cycle and then from the best so far, between the least
///    and the greatest level of the grid and within the machine's ranges. It minimises the time,
///    less a little for the depth that the last step cuts below size, plus a penalty for every
///    violated requirement, so that there is a slope where the time, a number of steps, has none.
/// 2. The result is rounded to values that can be set: the steps of the machine's ranges, or else
///    three significant digits of a feed; 0.0001 mm of stock. From there, and from the best so far,
///    single settings, or a setting and a stock, are changed by such steps as long as that helps.
///
/// Every trial is a full run by simulateUnchecked(), on the part and in every scenario, decided by
/// evaluateConstraints(): the answer is feasible, and it is the given cycle if no quicker one was
/// found. Nothing is proved: off the grid a still quicker cycle may be feasible.

namespace sparkout {

/// Settings of a cycle that a refinement may change, and their ranges.
class RefineSpace {
public:
    /// The project must have a grid.
    RefineSpace(const Project& project, Cycle cycle);

    struct Setting {
        std::size_t stage = 0;
        std::optional<double> Stage::*feed = nullptr; ///< null: the stage's stock
        double low = 0, high = 0;
        double base = 0, step = 0; ///< base + k·step; 0: three significant digits
        [[nodiscard]] bool isStock() const { return feed == nullptr; }
        /// Returns the step at a value.
        [[nodiscard]] double stepAt(double value) const;
        /// Returns the nearest value that can be set.
        [[nodiscard]] double rounded(double value) const;
    };
    [[nodiscard]] const std::vector<Setting>& settings() const { return m_settings; }

    [[nodiscard]] std::vector<double> valuesOf(const Cycle& cycle) const;
    /// Returns the cycle with these settings; its last stage takes the remaining stock. Returns
    /// nullopt if that is too little or too much, or if a feed rises that must not.
    [[nodiscard]] std::optional<Cycle> cycleOf(const std::vector<double>& values) const;
    [[nodiscard]] std::vector<double> rounded(std::vector<double> values) const;

private:
    void addFeeds(const StageFeed& feed, const Optimisation& asked, const MachineLimits& limits);
    void addStocks(const Optimisation& asked);

    Operation m_operation;
    Cycle m_cycle;
    std::vector<Setting> m_settings;
    double m_stock_mm, m_leastLast_mm, m_mostLast_mm;
    bool m_nonIncreasing;
};

/// Step to which stocks are rounded [mm].
inline constexpr double refinedStock_mm = 1e-4;

struct RefineOptions {
    std::vector<Project> scenarios; ///< further scenarios in which the cycle must be fit
    FreshScenarios source; ///< if given, the cycle must also be fit in the scenarios it draws and
                           ///< for every stock, or in fresh phases, and on fresh parts of a
                           ///< batch whose corners are searched
    int mostRuns =
        4000; ///< greatest number of cycles run, in each of at most ten rounds with a source
    bool everyStageSteps = false; ///< as in SearchOptions
    bool asksCapability = false;  ///< the given cycle is FreshParts::isCapable, the answer must be
    int candidates = 0;           ///< number of cycles that the search tried on fresh phases
    std::stop_token stop; ///< after a stop the best found is the answer; with a source the given
                          ///< cycle, unless all its scenarios were tried
};

struct RefineSummary {
    Cycle cycle;
    std::int64_t time_us = 0; ///< rounded for comparison; 0: stopped before the given cycle was run
    double time_s = 0;        ///< unrounded, from simulate(); 0: not run
    double leastRelativeMargin = 0;
    long long runs = 0;     ///< cycles that were run
    bool isQuicker = false; ///< quicker than the given cycle
    int candidate = 0; ///< number of the answer among the cycles tried on fresh phases, those of
                       ///< the search included; 0: it is the given cycle, or no source was given
    FreshParts freshParts; ///< of a quicker cycle, with a source
};

/// Refines a feasible cycle of a project with a grid. The machine settings are those of the
/// project, in the scenarios too, and a spark-out keeps its count.
[[nodiscard]] RefineSummary refine(const Project& project, const Cycle& cycle,
                                   const RefineOptions& options = {});

} // namespace sparkout
