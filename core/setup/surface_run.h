// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/setup/wheel_wear.h"
#include "core/simulation/result.h"

#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// The cycle of one surface of a set-up.
struct SurfaceRun {
    std::string name;
    SimulationResult result;
    std::vector<ConstraintResult> constraints;
    double removed_mm3 = 0;

    [[nodiscard]] RemovedMetal removed() const { return removedMetal(result.project, removed_mm3); }
    [[nodiscard]] bool isCompleted() const { return result.status == RunStatus::completed; }
    [[nodiscard]] bool holds() const; ///< completed, and every checked requirement is met
};

[[nodiscard]] SurfaceRun runSurface(const std::string& name, const Project& project,
                                    const std::stop_token& stop);

} // namespace sparkout
