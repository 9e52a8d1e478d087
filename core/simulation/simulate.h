// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <stop_token>

namespace sparkout {

/// Runs the cycle of a project, pass by pass [MODEL-2…7]. Every visit is recorded in the
/// trajectory, if one is given; without it a pass allocates nothing. A stop request ends the run
/// within a revolution, with RunStatus::stopped; a step that was cut short does not count. A
/// project that validate() refuses gives only RunStatus::refused.
[[nodiscard]] SimulationResult simulate(const Project& project, Trajectory* trajectory = nullptr,
                                        const std::stop_token& stop = {});

/// Like simulate(), for a project that is known to be valid, as the parts of a batch and the
/// scenarios of a search are: validation takes a fifth of the time of a short cycle. An unknown
/// number of lobes counts as three; two lobes are not evaluated.
[[nodiscard]] SimulationResult simulateUnchecked(const Project& project,
                                                 Trajectory* trajectory = nullptr,
                                                 const std::stop_token& stop = {});

/// Adds the diameters with two lobes, where the machine prints an unknown number of lobes and the
/// cycle is completed.
void addEvenLobes(SimulationResult& result, const std::stop_token& stop = {});

/// Runs the cycle of a traverse project with the gauge in the middle of another zone, for a
/// comparison of gauge positions. The position is not an input; simulate() has the gauge in НЗ.
[[nodiscard]] SimulationResult simulateTraverseGaugedIn(Zone zone, const Project& project,
                                                        const std::stop_token& stop = {});

} // namespace sparkout
