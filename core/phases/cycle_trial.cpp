// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/cycle_trial.h"

#include "core/quality/constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"

#include <algorithm>

namespace sparkout {

std::optional<CycleTrial> tried(const Project& project, const std::stop_token& stop) {
    const SimulationResult result = simulateUnchecked(project, nullptr, stop);
    if (result.status == RunStatus::stopped) {
        return std::nullopt;
    }
    if (result.status != RunStatus::completed) {
        return CycleTrial{};
    }
    CycleTrial trial{true, std::numeric_limits<double>::infinity(), removedVolume_mm3(result)};
    for (const ConstraintResult& constraint : evaluateConstraints(result)) {
        trial.holds &= constraint.holds;
        trial.leastMargin = std::min(trial.leastMargin, constraint.relativeMargin);
    }
    return trial;
}

} // namespace sparkout
