// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/binding.h"

#include "core/optimisation/cycle_runner.h"
#include "core/simulation/simulate.h"

#include <array>

namespace sparkout {

namespace {

bool differInOneFeed(const FeedSetting& a, const FeedSetting& b) {
    return (a.radial != b.radial) != (a.axialFeed_mm_min != b.axialFeed_mm_min);
}

bool mayBeRun(const Grid& grid, const GridCycle& cycle) {
    for (std::size_t z = 1; z < cycle.size(); ++z) {
        if (!grid.mayFollow(cycle[z - 1].setting, cycle[z].setting)) {
            return false;
        }
    }
    return true;
}

/// Other feeds in one stage.
void addFeeds(const Grid& grid, const GridCycle& best, std::vector<GridCycle>& found) {
    for (std::size_t z = 0; z < best.size(); ++z) {
        for (std::size_t s = 0; s < grid.settings().size(); ++s) {
            GridCycle other = best;
            other[z].setting = s;
            if (differInOneFeed(grid.settings()[s], grid.settings()[best[z].setting])
                && mayBeRun(grid, other)) {
                found.push_back(std::move(other));
            }
        }
    }
}

/// Other shares of two neighbours' stock; of the last stage's at least what the grid leaves it.
void addShares(const Grid& grid, const GridCycle& best, std::vector<GridCycle>& found) {
    int taken = 0;
    for (std::size_t z = 0; z + 1 < best.size(); ++z) {
        const bool beforeLast = z + 2 == best.size();
        const int most =
            beforeLast ? grid.mostSteps() - taken : best[z].steps + best[z + 1].steps - 1;
        for (int steps = grid.leastOf(best.size() - z, taken); steps <= most; ++steps) {
            GridCycle other = best;
            other[z].steps = steps;
            other[z + 1].steps += beforeLast ? 0 : best[z].steps - steps;
            if (steps != best[z].steps) {
                found.push_back(std::move(other));
            }
        }
        taken += best[z].steps;
    }
}

} // namespace

std::vector<ConstraintKind> bindingRequirements(const Project& project, const FeasibleCycle& best,
                                                const std::vector<Project>& scenarios) {
    const Grid grid(project);
    std::vector<Project> parts = scenarios;
    parts.insert(parts.begin(), project);
    std::array<bool, constraintKinds> binds{};
    std::vector<GridCycle> others;
    addFeeds(grid, best.cycle, others);
    addShares(grid, best.cycle, others);
    for (const GridCycle& other : others) {
        for (Project& part : parts) {
            part.cycle = grid.cycle(other);
            const SimulationResult result = simulate(part);
            if (&part == &parts.front() && comparedTime_us(result.time_s) >= best.time_us) {
                break;
            }
            for (const ConstraintResult& each : evaluateConstraints(result)) {
                binds[static_cast<std::size_t>(each.kind)] |= !each.holds;
            }
        }
    }
    std::vector<ConstraintKind> kinds;
    for (std::size_t kind = 0; kind < binds.size(); ++kind) {
        if (binds[kind]) {
            kinds.push_back(static_cast<ConstraintKind>(kind));
        }
    }
    return kinds;
}

} // namespace sparkout
