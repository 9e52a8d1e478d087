// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <optional>
#include <vector>

namespace sparkout {

/// What keeps the best cycle of a search from being quicker: the requirements that break, on the
/// part or in a scenario, in the quicker cycles of the grid that differ from it in one feed of one
/// stage, in the work speed, a dwell or the count of a spark-out, or in how two stages that follow
/// each other share their stock. In the order of the kinds; none where no such cycle is quicker, or
/// those that are hold. Nothing: not known, as it was stopped before all were tried.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
bindingRequirements(const Project& project, const FeasibleCycle& best,
                    const std::vector<Project>& scenarios = {}, const std::stop_token& stop = {});

/// The same of a cycle off the grid that takes so long, run with the project's machine: in quicker
/// cycles that differ from it in one setting of RefineSpace, or in one and a stock, by up to 64 of
/// their steps.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
bindingRequirements(const Project& project, const Cycle& cycle, std::int64_t time_us,
                    const std::vector<Project>& scenarios = {}, const std::stop_token& stop = {});

/// What keeps the margin of a project's cycle, the answer of a search for the greatest one, from
/// being greater: the requirements with the least relative margin on the part, and in a robust
/// search on all that the answer must hold for. Nothing: not known, as it was stopped before.
[[nodiscard]] std::optional<std::vector<ConstraintKind>>
leastMarginRequirements(const Project& best, bool isRobust, const std::stop_token& stop = {});

} // namespace sparkout
