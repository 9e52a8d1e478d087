// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"
#include "core/simulation/result.h"

#include <optional>
#include <vector>

namespace sparkout {

/// One setting of the machine held against what the machine can be set to [MODEL-8], in the
/// range's own unit: mm a double stroke, mm/min, mm/min, rev/min.
struct MachineRange {
    ConstraintKind kind;
    int stage = 0; ///< stage of the cycle, from 1; 0: set once for the whole cycle
    double value = 0;
    double low = 0, high = 0, step = 0;
    double nearest = 0;  ///< the nearest value the machine can be set to
    bool onStep = false; ///< whether the value is it, to 1e-6 of a step
};

/// Every feed and speed that the cycle sets and the machine limits, in the order of the kinds:
/// traverse S_t and S_ax of each stage, S_rad and S_c of each stage that has one; plunge S_p of
/// each stage; n. A stage that only sparks out sets no infeed. Of one kind, where only that is
/// asked for.
[[nodiscard]] std::vector<MachineRange> checkMachineRanges(const Project& project,
                                                           std::optional<ConstraintKind> only = {});

/// Stages against the commands of the gauge [MODEL-8].
struct GaugeCommands {
    int stages = 0;
    int commands = 0;
};

/// Nothing where the wheel head's position ends the stages.
[[nodiscard]] std::optional<GaugeCommands> checkGaugeCommands(const Project& project);

/// Below this overlap B·n/S_ax the table advances more than the wheel's width in a revolution, and
/// strips between the turns stay uncut [MODEL-7].
inline constexpr double leastOverlap = 1;

/// Of a stroke with an axial feed.
[[nodiscard]] double overlapOf(const Project& project, double axialFeed_mm_min);
/// Whether it is the least one or more; a last bit fails no one.
[[nodiscard]] constexpr bool holdsOverlap(double overlap, double least) {
    return overlap >= least * (1 - 1e-9);
}
/// Whether it leaves strips.
[[nodiscard]] constexpr bool leavesStrips(double overlap) {
    return !holdsOverlap(overlap, leastOverlap);
}

/// The overlap of one stage of a traverse cycle, against the one least that counts for it.
struct OverlapCheck {
    ConstraintKind kind = ConstraintKind::overlap; ///< the requirement that has it
    int stage = 0;                                 ///< from 1
    double overlap = 0;
    double least = leastOverlap;
    [[nodiscard]] bool holds() const { return holdsOverlap(overlap, least); }
};

/// Of a stroke in the last stage of a cycle or in another one. Where strips are left it is the
/// overlap of 1, whatever more is required; else the greatest that is.
[[nodiscard]] OverlapCheck checkOverlap(const Project& project, double axialFeed_mm_min, bool last);
/// Of each stage that has an axial feed; none in plunge grinding.
[[nodiscard]] std::vector<OverlapCheck> checkOverlaps(const Project& project);

/// Whether a stage of the cycle leaves strips: then the size, form and roughness that are computed
/// are those of the cut surface alone.
[[nodiscard]] bool leavesStrips(const Project& project);

/// How many double strokes or revolutions a stage made.
struct StageSteps {
    int stage = 0; ///< from 1
    int steps = 0;
};

/// The first of the stages that made the fewest, of those that have stock and end by gauge or
/// position: how many a spark-out by number makes is set. Nothing: there is no such stage.
[[nodiscard]] std::optional<StageSteps> fewestSteps(const SimulationResult& result);

} // namespace sparkout
