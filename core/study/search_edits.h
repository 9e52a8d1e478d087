// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

/// Edits of the search for a project's quickest cycle.
namespace sparkout {

/// Returns the project with a usual grid: preferred numbers over the machine's whole ranges as
/// levels of the feeds, which follow the answer, about 15 steps of stock, up to two stages or three
/// where the cycle has them, and feeds that never rise.
[[nodiscard]] Project withUsualSearch(Project project);

/// Returns the project with the usual practical limits of a stage where it states none: least
/// overlap of every stage and of the last, least number of steps. A cycle that a shop would not run
/// then violates a requirement, possibly also the current one.
[[nodiscard]] Project withPracticalLimits(Project project);

/// Returns the project with the usual search that is offered: with practical limits, so that its
/// answer can be run.
[[nodiscard]] Project withOfferedSearch(Project project);

/// Returns the project with usual levels in its search for those feeds of its operation that have
/// none. All other inputs of the search are kept, including those for the other operation.
[[nodiscard]] Project withSearchFor(Project project);

/// Returns whether a search of two projects has the same answer: only their cycles, names, notes
/// and kept runs differ.
[[nodiscard]] bool sameSearch(const Project& a, const Project& b);

} // namespace sparkout
