// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

namespace sparkout {

/// Runs every cycle of the grid from the blank, on as many threads as asked for, until it ends, is
/// slower than the best or breaks a requirement; can be stopped and gone on with. Fills everything
/// but `cycle` and `gridSize`.
[[nodiscard]] SearchSummary fullSearch(const Project& project, const Grid& grid,
                                       const SearchOptions& options);

} // namespace sparkout
