// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/recorded_step.h"

#include <cstdlib>
#include <set>

namespace sparkout {

namespace {

/// Whether two places differ only in the double stroke or revolution of the cycle.
bool alike(const Place& a, const Place& b) {
    return a.zone == b.zone && a.step == b.step && a.section == b.section && a.stage == b.stage
           && a.revolution == b.revolution;
}

} // namespace

const Visit* visitAt(const Trajectory& trajectory, const RecordedStep& step) {
    return &trajectory.visits[trajectory.passes[step.pass].firstVisit
                              + static_cast<std::size_t>(step.radius)];
}

const Visit* visitAt(const Trajectory& trajectory, const Place& place, int radius) {
    for (std::size_t i = 0; i < trajectory.passes.size() && radius < trajectory.radii; ++i) {
        const Place& at = trajectory.passes[i].place;
        if (alike(at, place) && at.cycleCount == place.cycleCount) {
            return visitAt(trajectory, {i, radius});
        }
    }
    return nullptr;
}

std::optional<Place> sharedPlace(const Trajectory& one, const Trajectory& other,
                                 const Place& place) {
    std::set<int> counts;
    for (const Pass& pass : one.passes) {
        if (alike(pass.place, place)) {
            counts.insert(pass.place.cycleCount);
        }
    }
    std::optional<Place> nearest;
    for (const Pass& pass : other.passes) {
        const int count = pass.place.cycleCount;
        if (alike(pass.place, place) && counts.contains(count)
            && (!nearest
                || std::abs(count - place.cycleCount)
                       < std::abs(nearest->cycleCount - place.cycleCount))) {
            nearest = pass.place;
        }
    }
    return nearest;
}

} // namespace sparkout
