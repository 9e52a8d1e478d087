// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/cycle_steps.h"

#include <memory>
#include <stop_token>

namespace sparkout {

/// A dwell in whole revolutions: ⌊x + 0.5 + 1e-9⌋, at least 1 when there is a dwell [MODEL-5].
[[nodiscard]] int dwellRevolutions(double dwell_s, double workSpeed_rpm);

/// The gauge of a traverse cycle stands in the middle of a zone.
[[nodiscard]] std::unique_ptr<CycleSteps> traverseSteps(const Project& project, Zone gaugeZone,
                                                        Trajectory* trajectory,
                                                        const std::stop_token& stop);

[[nodiscard]] SimulationResult simulateTraverse(const Project& project, Trajectory* trajectory,
                                                const std::stop_token& stop);

} // namespace sparkout
