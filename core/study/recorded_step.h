// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/trajectory.h"

#include <cstddef>
#include <optional>

namespace sparkout {

/// A visit of the wheel to one radius in a recorded run.
struct RecordedStep {
    std::size_t pass = 0; ///< index in the trajectory
    int radius = 0;       ///< k
    friend bool operator==(const RecordedStep&, const RecordedStep&) = default;
};

[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const RecordedStep& step);

/// Returns the visit of a radius at a place; null if there is none.
[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const Place& place, int radius);

/// Returns the place nearest to the given one, by double stroke or revolution, at which both runs
/// have this zone, stage, step and revolution; empty if there is none.
[[nodiscard]] std::optional<Place> sharedPlace(const Trajectory& one, const Trajectory& other,
                                               const Place& place);

} // namespace sparkout
