// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/refine.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// A search and what its answer is to be read with.
struct OptimiseReport {
    Project project; ///< as read: the given cycle
    SearchMethod method = SearchMethod::pruned;
    SearchSummary search;
    std::optional<RobustSummary> robust; ///< of which the search is the last
    std::optional<RefineSummary> refined;
    double limit_s = 0; ///< stepless
    std::vector<ConstraintKind> binding;
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
