// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/state_grid.h"

#include <cstddef>

namespace sparkout {

/// A moment of filling a grid: states are filled level by level, in each from the least feed on;
/// then the path is read back from the last level.
struct GridMoment {
    int level = 0; ///< level of the current state; 0: the blank, nothing is filled
    std::size_t feed = 0;
    int stepsBack = 0; ///< states read back so far, with that one
};

/// The number of moments after that of the blank.
[[nodiscard]] int momentCount(const StateGrid& grid);
[[nodiscard]] GridMoment momentAt(const StateGrid& grid, int number);
/// The moment in which a state is filled.
[[nodiscard]] int momentOf(const StateGrid& grid, int level, std::size_t feed);
/// The moment of the last filled state.
[[nodiscard]] int momentsOfFilling(const StateGrid& grid);

} // namespace sparkout
