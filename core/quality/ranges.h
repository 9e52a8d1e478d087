// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <optional>
#include <vector>

namespace sparkout {

enum class RangeKind { radialFeed, axialFeed, plungeFeed, workSpeed };

/// One setting of the machine held against what the machine can be set to [MODEL-8], in the
/// range's own unit: mm a double stroke, mm/min, mm/min, rev/min.
struct RangeCheck {
    RangeKind kind;
    int stage = 0; ///< stage of the cycle, from 1; 0: set once for the whole cycle
    double value = 0;
    double low = 0, high = 0, step = 0;
    double margin = 0;         ///< distance to the nearer end, positive inside
    double relativeMargin = 0; ///< margin over the width of the range
    bool holds = false;
    double nearest = 0;  ///< the nearest value the machine can be set to
    bool onStep = false; ///< whether the value is it, to 1e-6 of a step
};

/// Every feed and speed that the cycle sets and the machine limits, in the order of the kinds:
/// traverse S_t and S_ax of each stage and S_rad; plunge S_p of each stage; n. A stage that only
/// sparks out sets no infeed.
[[nodiscard]] std::vector<RangeCheck> checkMachineRanges(const Project& project);

/// Stages against the commands of the gauge [MODEL-8].
struct GaugeCommands {
    int stages = 0;
    int commands = 0;
    [[nodiscard]] int margin() const { return commands - stages; }
    [[nodiscard]] bool holds() const { return stages <= commands; }
};

/// Nothing where the wheel head's position ends the stages.
[[nodiscard]] std::optional<GaugeCommands> checkGaugeCommands(const Project& project);

} // namespace sparkout
