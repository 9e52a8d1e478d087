// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <cstddef>
#include <vector>

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

/// Moment of a recorded cycle: the passes before `open` are done; of the simultaneous passes from
/// `open` to `end`, the radii up to and including `radius` are done. At the blank all are 0.
struct Progress {
    std::size_t open = 0; ///< index of a pass
    std::size_t end = 0;  ///< past the last pass
    int radius = 0;       ///< k

    [[nodiscard]] bool isBlank() const { return end == 0; }
};

/// Returns the moment at the end of a double stroke or revolution; 0: the blank.
[[nodiscard]] Progress progressAfter(const Trajectory& trajectory, int stroke);

/// Returns whether all radii of its double stroke or revolution are done.
[[nodiscard]] bool endsStroke(const Trajectory& trajectory, const Progress& progress);

/// Returns the time of a moment from the start of the cycle [s]; the radii of a pass are
/// distributed evenly over it.
[[nodiscard]] double timeOf(const Trajectory& trajectory, const Progress& progress);

/// Returns the index of a pass's zone or section in a result.
[[nodiscard]] std::size_t sectionOf(const Place& place);

/// Last visit of each radius, by zone or section; null if there is none.
using LastVisits = std::vector<std::vector<const Visit*>>;
[[nodiscard]] LastVisits lastVisits(const Trajectory& trajectory, std::size_t sections,
                                    const Progress& progress);

} // namespace sparkout
