// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

namespace sparkout {

/// Runs every cycle of the grid from the blank, on `threads` threads, until the cycle ends, is
/// slower than the best or violates a requirement. The search can be stopped and resumed. Fills the
/// whole summary except `cycle` and `gridSize`.
[[nodiscard]] SearchSummary fullSearch(const Project& project, const Grid& grid,
                                       const SearchOptions& options);

} // namespace sparkout
