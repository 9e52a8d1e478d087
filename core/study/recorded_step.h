// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/trajectory.h"

#include <cstddef>
#include <optional>

namespace sparkout {

/// One radius under the wheel once, in a recorded run.
struct RecordedStep {
    std::size_t pass = 0; ///< index in the trajectory
    int radius = 0;       ///< k
    friend bool operator==(const RecordedStep&, const RecordedStep&) = default;
};

[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const RecordedStep& step);

/// The visit of a radius at a place; null: there is none.
[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const Place& place, int radius);

/// The double stroke or revolution nearest to that of a place in which both runs are at this zone,
/// stage, step and revolution; nothing when there is none.
[[nodiscard]] std::optional<Place> sharedPlace(const Trajectory& one, const Trajectory& other,
                                               const Place& place);

} // namespace sparkout
