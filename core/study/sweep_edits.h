// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_run.h"

#include <string>

/// Edits of a project that have to do with its sweep.
namespace sparkout {

/// A varied input with a usual range about the project's own value of it, as far as it is allowed.
[[nodiscard]] SweepAxis usualAxis(const Project& project, const std::string& path);

/// The project that varies another input at a place of its sweep, 0 or 1; an empty path: none
/// there.
[[nodiscard]] Project withSweptInput(Project project, std::size_t place, const std::string& path);

/// The project with another range at a place; unchanged when another input is varied there by now.
[[nodiscard]] Project withSweepAxis(Project project, std::size_t place, const SweepAxis& axis);

/// The project with the values of the inputs at a point of a sweep, as far as it still has them.
[[nodiscard]] Project withPoint(Project project, const SweepResult& sweep, std::size_t point);

/// Whether two projects make the same sweep: nothing differs but names, notes, batch, search, kept
/// runs and the present values of what is varied.
[[nodiscard]] bool sameSweep(const Project& a, const Project& b);

} // namespace sparkout
