// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/sweep_run.h"

#include <string>

/// Edits of a project's sweep.
namespace sparkout {

/// Returns a varied input with a usual range about the project's own value, within the allowed
/// range.
[[nodiscard]] SweepAxis usualAxis(const Project& project, const std::string& path);

/// Returns the project with another varied input at a place of its sweep, 0 or 1; an empty path
/// removes it.
[[nodiscard]] Project withSweptInput(Project project, std::size_t place, const std::string& path);

/// Returns the project with another range at a place; unchanged if another input is now varied
/// there.
[[nodiscard]] Project withSweepAxis(Project project, std::size_t place, const SweepAxis& axis);

/// Returns the project with the values of the inputs at a point of a sweep, as far as it still has
/// these inputs.
[[nodiscard]] Project withPoint(Project project, const SweepResult& sweep, std::size_t point);

/// Returns whether two projects make the same sweep: only names, notes, batch, search, kept runs
/// and the current values of the varied inputs differ.
[[nodiscard]] bool sameSweep(const Project& a, const Project& b);

} // namespace sparkout
