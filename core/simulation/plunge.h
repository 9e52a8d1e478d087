// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/cycle_loop.h"

#include <memory>
#include <stop_token>

namespace sparkout {

[[nodiscard]] std::unique_ptr<CycleSteps>
plungeSteps(const Project& project, Trajectory* trajectory, const std::stop_token& stop);

[[nodiscard]] SimulationResult simulatePlunge(const Project& project, Trajectory* trajectory,
                                              const std::stop_token& stop);

} // namespace sparkout
