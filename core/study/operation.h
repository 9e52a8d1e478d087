// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

/// Edits that must change several inputs together.
namespace sparkout {

/// The project under another operation: feeds, compliance, overruns and gauge get values the new
/// operation can run with; what it does not read is cleared. The wheel stays, so that a length may
/// be too short to be traversed with it. A search gets levels for the feeds of the new operation.
[[nodiscard]] Project withOperation(Project project, Operation operation);

/// The project with what suits an operation: for traverse overruns that leave a zone between the
/// reversals, where the wheel allows it, for plunge a ground length that the wheel covers.
[[nodiscard]] Project fitted(Project project, Operation operation);

/// The project with another number of plunge sections; a listed compliance follows.
[[nodiscard]] Project withSections(Project project, int sections);

/// The project with its compliance entered directly (true) or computed from stiffness and shaft,
/// which get usual values where they are not given.
[[nodiscard]] Project withGivenCompliance(Project project, bool given);

/// The project with what a compliance left to stiffness and shaft needs; otherwise unchanged.
[[nodiscard]] Project withComputable(Project project);

/// The project with a measured profile as the form of its blank, a radius a value.
[[nodiscard]] Project withRadii(Project project, std::vector<double> radii_um);

} // namespace sparkout
