// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/progress.h"
#include "core/simulation/result.h"

#include <array>
#include <vector>

namespace sparkout {

/// A quantity of one stage of the cycle, divided among the steps of its double strokes; in plunge
/// grinding all of it belongs to `none`.
struct StepSums {
    std::array<double, strokeSteps> of{};

    [[nodiscard]] double& operator[](StrokeStep step) { return of[static_cast<std::size_t>(step)]; }
    [[nodiscard]] double operator[](StrokeStep step) const {
        return of[static_cast<std::size_t>(step)];
    }
    [[nodiscard]] double total() const;
};

/// Time and removed stock of each stage and step of a cycle.
///
/// The times add up to those of the stages and so to that of the cycle, dwells and spark-outs
/// included: a stroke, which grinds all three zones at once, counts once. The depths of a zone or
/// section, means over its radii, add up to its total removal: its mean radius before the cycle
/// less that after it, in a bore the reverse.
struct StepShares {
    std::vector<StepSums> time_s;                  ///< by stage
    std::vector<std::vector<StepSums>> removed_mm; ///< Σa per side, by zone or section, then stage

    [[nodiscard]] bool empty() const { return time_s.empty(); } ///< the run was not recorded
};

[[nodiscard]] StepShares stepShares(const SimulationResult& result, const Trajectory& trajectory);

} // namespace sparkout
