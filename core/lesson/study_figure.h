// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/figure.h"
#include "core/project/project.h"

#include <optional>

/// Figures of what is more than one run: of the project's batch, of its search, of dynamic
/// programming on its levels. Each is computed anew.
namespace sparkout {

/// Of the batch, or of a zone or section over it; nothing: the project has no batch that can be
/// run, or the figure is not known of it.
[[nodiscard]] std::optional<double> batchFigure(const Figure& figure, const Project& project);

/// Of the search; nothing: the project has no grid, or no cycle of it holds.
[[nodiscard]] std::optional<double> searchFigure(const Figure& figure, const Project& project);

} // namespace sparkout
