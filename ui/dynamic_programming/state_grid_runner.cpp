// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dynamic_programming/state_grid_runner.h"

#include <algorithm>
#include <utility>

namespace sparkout {

void StateGridRunner::fill(const Project& project, StateGridSize size) {
    run(size.levels, [this, project, size](const Means& means) {
        std::optional<StateGrid> grid =
            fillStateGrid(project, size, means.stop, [&means](int level) { *means.done = level; });
        StateGridOutcomePtr outcome;
        if (grid) {
            outcome = std::make_shared<StateGridOutcome>(
                StateGridOutcome{project, std::move(*grid), std::nullopt});
        }
        return [this, outcome = std::move(outcome)] { emit this->filled(outcome); };
    });
}

void StateGridRunner::prove(const StateGridOutcomePtr& filled) {
    run(proofParts, [this, filled](const Means& means) {
        auto outcome = std::make_shared<StateGridOutcome>(*filled);
        outcome->exact =
            exactAnswer(filled->grid, means.stop, [&means](const SearchProgress& progress) {
                if (progress.best && progress.best->time_s > 0) {
                    const double share =
                        std::clamp(progress.bound_s / progress.best->time_s, 0.0, 1.0);
                    *means.done = static_cast<std::int64_t>(share * proofParts);
                }
            });
        return [this, outcome = StateGridOutcomePtr(std::move(outcome))] { emit proved(outcome); };
    });
}

} // namespace sparkout
