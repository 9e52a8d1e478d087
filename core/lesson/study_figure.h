// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/figure.h"
#include "core/project/project.h"

#include <optional>

/// Figures that need more than one run: of the project's batch, its search, or dynamic programming
/// on its levels. Each call computes them anew.
namespace sparkout {

/// A figure of the batch, or of a zone or section over it; empty if the project's batch cannot be
/// run, or the figure is not known.
[[nodiscard]] std::optional<double> batchFigure(const Figure& figure, const Project& project);

/// A figure of the search; empty without a grid or without a fit cycle.
[[nodiscard]] std::optional<double> searchFigure(const Figure& figure, const Project& project);

} // namespace sparkout
