// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// Whether the wheel may run over an end of the ground length: not into a shoulder, nor the wall of
/// a blind bore.
struct StartingEnds {
    bool freeAtHeadstock = true;
    bool freeAtTailstock = true;
};

/// What keeps the rough depth of cut of a starting cycle from being greater.
enum class RoughBound {
    table,      ///< usual depths and feeds [MH31]
    power,      ///< the wheel drive's power
    deflection, ///< of machine and part
    burn,       ///< the damaged layer
    range,      ///< the machine's highest feed
};
/// Its name in files: "table", "power".
[[nodiscard]] const char* roughBoundKey(RoughBound bound);
/// "the wheel drive's power"; to be translated as "StartingCycle".
[[nodiscard]] const char* roughBoundText(RoughBound bound);

/// A project with a starting cycle, and why its roughing is no deeper.
struct StartingCycle {
    Project project;
    RoughBound bound = RoughBound::table;
    bool isExceeded = false;  ///< the machine's lowest feed is more than that allows
    double roughDepth_mm = 0; ///< a, fed by a revolution or a double stroke of roughing [mm]
    double tableShare = 1;    ///< of the usual depth
};

/// The project with what does not depend on the stages: the wheel's speed, which is the machine's
/// or the wheel's greatest, the lesser; overruns at free ends, S_rad, and least overlap and steps.
[[nodiscard]] Project withStartingEnds(Project project, const StartingEnds& ends);

/// Gives a project a cycle to start from: work speed, overruns, dwells, and the stages roughing,
/// finishing and spark-out, in steps of the machine [MODEL-15]. Part, shaft or compliance,
/// material, wheel and machine are the project's and must be valid; its stages are not looked at.
///
/// The cycle is for the nominal part, with room for a wheel half as dull again and a material
/// stronger by a tenth. Whether it holds for every stock, or for the batch, the caller decides
/// (decidePhases(), runBatch()). Roughness is not looked at beyond the choice of feeds.
[[nodiscard]] StartingCycle startingCycle(Project project, const StartingEnds& ends);

} // namespace sparkout
