// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/refine.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout::cli {

/// The file's own cycle, beside the one found.
struct GivenCycle {
    bool isStopped = false;       ///< before its end: nothing is known of it
    std::optional<double> time_s; ///< when it ends by itself
    std::vector<ConstraintKind> fails;
};
/// Runs it.
[[nodiscard]] GivenCycle givenCycle(const Project& project, const std::stop_token& stop);

/// A search and what its answer is to be read with.
struct OptimiseReport {
    Project project; ///< as read: the given cycle
    SearchMethod method = SearchMethod::pruned;
    SearchSummary search;
    std::optional<RobustSummary> robust; ///< of which the search is the last
    std::optional<RefineSummary> refined;
    double limit_s = 0;                                 ///< stepless
    std::optional<std::vector<ConstraintKind>> binding; ///< nothing: not known, or no cycle
    GivenCycle given;
};

/// A method as `--method` names it.
[[nodiscard]] const char* methodName(SearchMethod method);
[[nodiscard]] std::optional<SearchMethod> methodNamed(const std::string& name);

/// Whether there is a cycle to give: feasible, and tested where it must be robust.
[[nodiscard]] bool hasAnswer(const OptimiseReport& report);

/// The cycle to give: refined, or the best of the grid.
[[nodiscard]] const Cycle& cycleFound(const OptimiseReport& report);

/// For people.
[[nodiscard]] std::string optimiseText(const OptimiseReport& report);

/// The object of `optimize --json`; its named keys are fixed.
[[nodiscard]] std::string optimiseJson(const OptimiseReport& report);

/// Why there is no answer, with the requirements that cut most.
[[nodiscard]] std::string noAnswerSentence(const OptimiseReport& report);

} // namespace sparkout::cli
