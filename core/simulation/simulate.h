// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "core/simulation/trajectory.h"

#include <stop_token>

namespace sparkout {

/// Runs the cycle of a valid project (validate() found no error), pass by pass
/// [MODEL-2…7]. With a trajectory every visit is recorded in it, else a pass allocates nothing.
/// A stop request ends the run within a revolution, with RunStatus::stopped; a step that was cut
/// short does not count.
[[nodiscard]] SimulationResult simulate(const Project& project, Trajectory* trajectory = nullptr,
                                        const std::stop_token& stop = {});

} // namespace sparkout
