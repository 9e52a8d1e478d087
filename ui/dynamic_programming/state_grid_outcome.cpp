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

} // namespace sparkout
