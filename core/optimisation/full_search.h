// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

namespace sparkout {

/// Simulates and judges every cycle of the grid, on as many threads as asked for; can be stopped
/// and gone on with. Fills everything but `cycle` and `gridSize`.
[[nodiscard]] SearchSummary fullSearch(const Project& project, const Grid& grid,
                                       const SearchOptions& options);

} // namespace sparkout
