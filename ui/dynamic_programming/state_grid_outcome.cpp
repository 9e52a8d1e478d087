// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dynamic_programming/state_grid_outcome.h"

#include <algorithm>
#include <utility>

namespace sparkout {

StateGridOutcomePtr filledGrid(const Project& project, StateGridSize size,
                               const Job::Means& means) {
    std::optional<StateGrid> grid =
        fillStateGrid(project, size, means.stop, [&means](int level) { *means.done = level; });
    return grid ? std::make_shared<const StateGridOutcome>(
               StateGridOutcome{project, std::move(*grid), std::nullopt})
                : nullptr;
}

StateGridOutcomePtr provenGrid(const StateGridOutcome& filled, const Job::Means& means) {
    auto outcome = std::make_shared<StateGridOutcome>(filled);
    outcome->exact = exactAnswer(filled.grid, means.stop, [&means](const SearchProgress& progress) {
        if (progress.best && progress.best->time_s > 0) {
            const double share = std::clamp(progress.bound_s / progress.best->time_s, 0.0, 1.0);
            *means.done = static_cast<std::int64_t>(share * double(gridProofParts));
        }
    });
    return outcome;
}

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
