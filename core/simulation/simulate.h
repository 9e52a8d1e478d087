// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "core/simulation/trajectory.h"

#include <stop_token>

namespace sparkout {

/// Runs the cycle of a project, pass by pass [MODEL-2…7]. With a trajectory every visit is recorded
/// in it, else a pass allocates nothing. A stop request ends the run within a revolution, with
/// RunStatus::stopped; a step that was cut short does not count. A project that validate() refuses
/// gives RunStatus::refused and nothing else.
[[nodiscard]] SimulationResult simulate(const Project& project, Trajectory* trajectory = nullptr,
                                        const std::stop_token& stop = {});

/// The same of a project that is known to be valid, as the parts of a batch and the scenarios of a
/// search are: checking takes a fifth of the time of a short cycle. Lobes of a number not known
/// are three there, and nothing is said of two.
[[nodiscard]] SimulationResult simulateUnchecked(const Project& project,
                                                 Trajectory* trajectory = nullptr,
                                                 const std::stop_token& stop = {});

/// Adds what the diameters are with two lobes, where the machine prints a number of them that is
/// not known and the cycle is completed.
void addEvenLobes(SimulationResult& result, const std::stop_token& stop = {});

/// The cycle of a traverse project as if the gauge stood in the middle of another zone: for asking
/// where to put it. Its place is no input; simulate() has it in НЗ.
[[nodiscard]] SimulationResult simulateTraverseGaugedIn(Zone zone, const Project& project,
                                                        const std::stop_token& stop = {});

} // namespace sparkout
