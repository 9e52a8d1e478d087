// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/optimise.h"

#include <optional>
#include <vector>

namespace sparkout {

/// Returns the requirements that limit the time of the best cycle of a search: those that are
/// violated, on the part or in a scenario, by quicker cycles of the grid that differ from it in one
/// feed of one stage, in the work speed, a dwell or the count of a spark-out, or in how two
/// successive stages share their stock. They are in the order of the kinds; the list is empty if no
/// such cycle is quicker or all quicker ones are feasible. Returns nullopt if stopped before all
/// were tried.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
bindingRequirements(const Project& project, const FeasibleCycle& best,
                    const std::vector<Project>& scenarios = {}, const std::stop_token& stop = {});

/// Returns these requirements for a cycle off the grid with this time, run with the project's
/// machine. The quicker cycles differ from it in one setting of RefineSpace, or in one setting and
/// a stock, by up to 64 of their steps.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
bindingRequirements(const Project& project, const Cycle& cycle, std::int64_t time_us,
                    const std::vector<Project>& scenarios = {}, const std::stop_token& stop = {});

/// Returns the requirements that limit the margin of a project's cycle, the answer of a search for
/// the greatest margin: those with the least relative margin on the part and, in a robust search,
/// on all parts for which the answer must be fit. Returns nullopt if stopped.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
leastMarginRequirements(const Project& best, bool isRobust, const std::stop_token& stop = {});

/// Returns the requirements that a project's cycle meets with less than this relative margin, on
/// the part, in a scenario or, in a robust search, on a part that is drawn for it. They are in the
/// order of the kinds, without the ranges of the machine, which a setting may use to their ends.
/// Returns nullopt if stopped.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
requirementsBelowMargin(const Project& best, double margin, bool isRobust,
                        const std::vector<Project>& scenarios, const std::stop_token& stop = {});

} // namespace sparkout
