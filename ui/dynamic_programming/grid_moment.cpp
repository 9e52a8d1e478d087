// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dynamic_programming/grid_moment.h"

#include <algorithm>

namespace sparkout {

int momentsOfFilling(const StateGrid& grid) {
    return grid.size.levels * static_cast<int>(grid.feeds.size());
}

int momentCount(const StateGrid& grid) {
    return momentsOfFilling(grid) + static_cast<int>(grid.path.size());
}

GridMoment momentAt(const StateGrid& grid, int number) {
    const int feeds = static_cast<int>(grid.feeds.size());
    const int filling = momentsOfFilling(grid);
    number = std::clamp(number, 0, momentCount(grid));
    if (number == 0) {
        return {};
    }
    if (number <= filling) {
        return {(number - 1) / feeds + 1, static_cast<std::size_t>((number - 1) % feeds), 0};
    }
    const int stepsBack = number - filling;
    const int level = grid.size.levels - stepsBack + 1;
    return {level, grid.path[static_cast<std::size_t>(level - 1)], stepsBack};
}

int momentOf(const StateGrid& grid, int level, std::size_t feed) {
    return (level - 1) * static_cast<int>(grid.feeds.size()) + static_cast<int>(feed) + 1;
}

} // namespace sparkout
