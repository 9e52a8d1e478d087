// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"

/// The pass of PassFunction for a force with a threshold [MODEL-2, MODEL-3]. A lane cuts, touches
/// or is off:
///
///     a = (h − C)/A,  v = 1     where h > C,  C = γ·b·F'_0,  A = 1 + γ·b·K
///     a = 0,  v = h/C           where 0 < h ≤ C: the wheel presses with h/γ without cutting
///     a = 0,  v = 0             where h ≤ 0
///
/// The lanes keep v beside √a, see Lanes::keepRubbing().
namespace sparkout {

/// The state of a lane: the root u = √a [√mm] and the rubbing share v.
struct ThresholdState {
    double root = 0, rubbing = 0;
};

/// The state at a lag h [mm], with A4 = 4·A.
[[nodiscard]] ThresholdState thresholdState(double C, double A4, double h);

/// Puts a lane into a state and updates everything that a pass keeps of it.
void putState(Lanes& lanes, std::size_t lane, const ThresholdState& state);

/// Cuts the lanes of the range once; returns the largest √a [√mm].
double cutWithThreshold(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                        const PassRange& range);

/// Cuts the lanes with given states: C² is a, and C is v.
double cutAsGiven(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                  const PassRange& range);

} // namespace sparkout
