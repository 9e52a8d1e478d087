// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/trajectory.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// How far a recorded cycle has run: the passes before `open` are done; of those from `open` to
/// `end`, which run at the same time, the radii up to `radius`, it included. At the blank all 0.
struct Progress {
    std::size_t open = 0; ///< index of a pass
    std::size_t end = 0;  ///< past the last pass
    int radius = 0;       ///< k

    [[nodiscard]] bool isBlank() const { return end == 0; }
};

/// At the end of a double stroke or revolution; 0: the blank.
[[nodiscard]] Progress progressAfter(const Trajectory& trajectory, int stroke);

/// Whether its double stroke or revolution is done, of all radii.
[[nodiscard]] bool endsStroke(const Trajectory& trajectory, const Progress& progress);

/// Time at which it has got there, from the start of the cycle [s]; the radii of a pass are spread
/// evenly over it.
[[nodiscard]] double timeOf(const Trajectory& trajectory, const Progress& progress);

/// Index of a pass's zone or section among those of a result.
[[nodiscard]] std::size_t sectionOf(const Place& place);

/// For each zone or section the last visit of each of its radii; null: the wheel has not been
/// there.
using LastVisits = std::vector<std::vector<const Visit*>>;
[[nodiscard]] LastVisits lastVisits(const Trajectory& trajectory, std::size_t sections,
                                    const Progress& progress);

} // namespace sparkout
