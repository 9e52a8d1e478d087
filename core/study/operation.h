// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

/// Edits that must change several inputs together.
namespace sparkout {

/// Returns the project under another operation: feeds, compliance, overruns and gauge get values
/// that the new operation can run with; inputs that it does not use are cleared. The wheel is
/// unchanged, so a length may be too short to be traversed with it. A search gets levels for the
/// feeds of the new operation.
[[nodiscard]] Project withOperation(Project project, Operation operation);

/// Returns the project with lengths that suit an operation: for traverse grinding overruns that
/// leave a zone between the reversals, where the wheel allows it, for plunge grinding a ground
/// length that the wheel covers.
[[nodiscard]] Project fitted(Project project, Operation operation);

/// Returns the project with another number of plunge sections; a listed compliance follows.
[[nodiscard]] Project withSections(Project project, int sections);

/// Returns the project with its compliance entered directly (true) or computed from stiffness and
/// shaft, which get usual values where they are not given.
[[nodiscard]] Project withGivenCompliance(Project project, bool given);

/// Returns the project with the inputs that a compliance computed from stiffness and shaft needs;
/// otherwise unchanged.
[[nodiscard]] Project withComputable(Project project);

/// Returns the project with a measured profile as the form of its blank, one value a radius.
[[nodiscard]] Project withRadii(Project project, std::vector<double> radii_um);

/// Like withOperation(), but restores from `last`, the project's last state under that operation,
/// the feeds and those inputs of ground length, wheel, overruns, compliance, gauge and surface that
/// were not edited since. Switching there and back gives the same project.
[[nodiscard]] Project withOperation(const Project& project, Operation operation,
                                    const Project* last);

} // namespace sparkout
