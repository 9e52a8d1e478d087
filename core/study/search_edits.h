// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

/// Edits of a project that have to do with the search for its quickest cycle.
namespace sparkout {

/// The project with a usual grid: preferred numbers over the whole of the machine's ranges as
/// levels of the feeds, which follow the answer, some 15 steps of stock, up to two stages or three
/// where the cycle has them, feeds that never rise.
[[nodiscard]] Project withUsualSearch(Project project);

/// The project with the usual practical limits of a stage where it states none: least overlap of
/// every stage and of the last, least steps. What a shop would not run then breaks a requirement,
/// of the present cycle too.
[[nodiscard]] Project withPracticalLimits(Project project);

/// The usual search as one is offered: with practical limits, so that its answer can be run.
[[nodiscard]] Project withOfferedSearch(Project project);

/// The project with levels in its search for the feeds of its operation where there are none: usual
/// ones. What else is asked stays, and what is asked under the other operation too.
[[nodiscard]] Project withSearchFor(Project project);

/// Whether a search of two projects has the same answer: nothing but their cycles, names, notes and
/// kept runs differ.
[[nodiscard]] bool sameSearch(const Project& a, const Project& b);

} // namespace sparkout
