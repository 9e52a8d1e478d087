// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/outcome.h"

#include <stop_token>

namespace sparkout {

/// An ordinary plunge cycle made long: a dull wheel, a slow feed, as many radii as may be, in that
/// many sections: about a million visits each.
[[nodiscard]] Project longProject(int sections);

/// The project with a batch of measured blanks: their values, all printed in the passport, fill
/// more than that many pages.
[[nodiscard]] Project projectOfPages(Project project, int pages);

/// The project with so many kept runs, each with all its inputs.
[[nodiscard]] Project projectOfRuns(Project project, int runs);

/// Runs the cycle of a plunge of many sections over and over for three seconds, however quick the
/// machine is; others once.
/// A stop is heeded where the engine heeds it.
[[nodiscard]] OutcomePtr runForSeconds(const Project& project, const std::stop_token& stop);

} // namespace sparkout
