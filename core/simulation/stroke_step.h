// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <cstddef>

namespace sparkout {

/// Physical step of a double stroke to which a zone's step E1…E5 belongs.
enum class StrokeStep {
    plungeIn, ///< at the entry
    entryDwell,
    workingStroke,
    exitPlungeIn, ///< where the machine feeds at the exit
    exitDwell,
    returnStroke,
    dwellAfterReturn, ///< at the entry again
    none              ///< a revolution of plunge grinding
};
inline constexpr std::size_t strokeSteps = static_cast<std::size_t>(StrokeStep::none) + 1;

[[nodiscard]] StrokeStep strokeStep(Zone zone, Step step);
/// Returns the zone's step for a physical step; none if the zone is not ground in it.
[[nodiscard]] Step stepOf(Zone zone, StrokeStep step);

} // namespace sparkout
