// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/project.h"

namespace sparkout {

/// Whether the wheel may overrun an end of the ground length: not a shoulder, nor the wall of a
/// blind bore.
struct StartingEnds {
    bool freeAtHeadstock = true;
    bool freeAtTailstock = true;

    [[nodiscard]] int freeCount() const {
        return (freeAtHeadstock ? 1 : 0) + (freeAtTailstock ? 1 : 0);
    }
};

/// The bound of the rough depth of cut of a starting cycle.
enum class RoughBound {
    table,      ///< usual depths and feeds [MH31]
    power,      ///< the wheel drive's power
    deflection, ///< deflection of machine and part
    burn,       ///< the damaged layer
    range,      ///< the machine's highest feed
};
/// The key in files: "table", "power".
[[nodiscard]] const char* roughBoundKey(RoughBound bound);
/// "the wheel drive's power"; to be translated as "StartingCycle".
[[nodiscard]] const char* roughBoundText(RoughBound bound);

/// A project with a starting cycle, and the bound of its roughing depth.
struct StartingCycle {
    Project project;
    RoughBound bound = RoughBound::table;
    bool isExceeded = false;  ///< the machine's lowest feed is more than that allows
    double roughDepth_mm = 0; ///< a, infeed per revolution or double stroke of roughing [mm]
    double usualDepth_mm = 0; ///< a of the table
    double tableShare = 1;    ///< relative to the usual depth
};

/// The required Ra of a part [µm]; where none is required, one that suits the width of its field.
[[nodiscard]] double workRoughness_um(const Part& part);

/// Whether a material is hardened, or one whose hardness is not stated; iron is not.
[[nodiscard]] bool isHardened(const Material& material);
/// Grey, ductile and malleable iron: СЧ20, ВЧ50, КЧ30-6.
[[nodiscard]] bool isIron(const Material& material);

/// The overruns of a traverse at free ends [mm].
[[nodiscard]] double freeOverrun_mm(double width_mm, double length_mm, const StartingEnds& ends);

/// The project with the settings independent of the stages: the wheel speed, the lesser of the
/// machine's and the wheel's greatest; overruns at free ends, S_rad, and least overlap and steps.
[[nodiscard]] Project withStartingEnds(Project project, const StartingEnds& ends);

/// Gives a project a starting cycle: work speed, overruns, dwells, and the stages roughing,
/// finishing and spark-out, in steps of the machine [MODEL-15]. Part, shaft or compliance,
/// material, wheel and machine are those of the project and must be valid; its stages are ignored.
///
/// The cycle is for the nominal part, with allowance for a wheel half as dull again and a material
/// stronger by a tenth. The caller decides whether it is fit for every stock, or for the batch
/// (decidePhases(), runBatch()). Roughness only affects the choice of feeds.
[[nodiscard]] StartingCycle startingCycle(Project project, const StartingEnds& ends);

/// The stages of such a cycle on the project's machine as it is set: with its work speed, overruns
/// and dwells. A traverse of a part that yields unevenly along its length has more spark-outs, and
/// a smaller axial feed of finishing if need be, so that the lags behind it differ little.
[[nodiscard]] Cycle startingStages(const Project& project);

} // namespace sparkout
