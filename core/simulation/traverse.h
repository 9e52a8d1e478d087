// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/machine.h"
#include "core/simulation/cycle_loop.h"

#include <memory>
#include <stop_token>

namespace sparkout {

/// Returns a dwell in whole revolutions: ⌊x + 0.5 + 1e-9⌋, at least 1 when there is a dwell
/// [MODEL-5].
[[nodiscard]] int dwellRevolutions(double dwell_s, double workSpeed_rpm);

/// Radial feed S_t of a double stroke, divided between the reversals [MODEL-5].
struct ReversalFeeds {
    double entry_mm = 0; ///< S_1
    double exit_mm = 0;  ///< S_2
};
[[nodiscard]] ReversalFeeds reversalFeeds(ReversalInfeed at, double infeed_mm);

/// Returns a plunge-in in whole revolutions: ⌈n·S/S_rad − 1e-9⌉.
[[nodiscard]] int plungeInRevolutions(const Machine& machine, double infeed_mm);

/// Makes the steps of a traverse cycle with the gauge in the middle of a zone.
[[nodiscard]] std::unique_ptr<CycleSteps> traverseSteps(const Project& project, Zone gaugeZone,
                                                        Trajectory* trajectory,
                                                        const std::stop_token& stop);

[[nodiscard]] SimulationResult simulateTraverse(const Project& project, Trajectory* trajectory,
                                                const std::stop_token& stop);

/// Returns the time of the dwells and both strokes of a double stroke [s].
[[nodiscard]] double strokesAndDwells_s(const Project& project, double axialFeed_mm_min);

} // namespace sparkout
