// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/progress.h"

#include <algorithm>

namespace sparkout {

StrokeStep strokeStep(Zone zone, Step step) {
    using enum StrokeStep;
    constexpr StrokeStep rz1[] = {none,          plungeIn,     entryDwell,
                                  workingStroke, returnStroke, dwellAfterReturn};
    constexpr StrokeStep nz[] = {none, workingStroke, returnStroke, none, none, none};
    constexpr StrokeStep rz2[] = {none, workingStroke, exitDwell, returnStroke, exitPlungeIn, none};
    const int i = std::clamp(static_cast<int>(step), 0, 5);
    switch (zone) {
    case Zone::rz1: return rz1[i];
    case Zone::nz: return nz[i];
    case Zone::rz2: return rz2[i];
    case Zone::section: break;
    }
    return none;
}

Step stepOf(Zone zone, StrokeStep step) {
    for (const Step of : {Step::e1, Step::e2, Step::e3, Step::e4, Step::e5}) {
        if (step != StrokeStep::none && strokeStep(zone, of) == step) {
            return of;
        }
    }
    return Step::none;
}

Progress progressAfter(const Trajectory& trajectory, int stroke) {
    const auto after = std::ranges::partition_point(
        trajectory.passes, [stroke](const Pass& pass) { return pass.place.cycleCount <= stroke; });
    const auto end = static_cast<std::size_t>(after - trajectory.passes.begin());
    return {end, end, std::max(trajectory.radii - 1, 0)};
}

bool endsStroke(const Trajectory& trajectory, const Progress& progress) {
    const std::vector<Pass>& passes = trajectory.passes;
    const bool all = progress.open == progress.end || progress.radius + 1 == trajectory.radii;
    return progress.isBlank()
           || (all
               && (progress.end == passes.size()
                   || passes[progress.end].place.cycleCount
                          != passes[progress.end - 1].place.cycleCount));
}

double timeOf(const Trajectory& trajectory, const Progress& progress) {
    if (progress.isBlank()) {
        return 0;
    }
    const Pass& pass = trajectory.passes[progress.end - 1];
    const double share =
        progress.open == progress.end ? 1 : (progress.radius + 1.0) / std::max(trajectory.radii, 1);
    return pass.start_s + pass.duration_s * share;
}

std::size_t sectionOf(const Place& place) {
    return static_cast<std::size_t>(place.zone == Zone::section ? place.section
                                                                : static_cast<int>(place.zone));
}

LastVisits lastVisits(const Trajectory& trajectory, std::size_t sections,
                      const Progress& progress) {
    const auto radii = static_cast<std::size_t>(trajectory.radii);
    LastVisits last(sections, std::vector<const Visit*>(radii));
    std::size_t left = sections;
    for (std::size_t i = progress.end; i-- > 0 && left > 0;) {
        const Pass& pass = trajectory.passes[i];
        std::vector<const Visit*>& visits = last[sectionOf(pass.place)];
        // The last radius is visited last, and completes the section.
        if (radii == 0 || visits.back()) {
            continue;
        }
        const std::size_t done =
            i < progress.open ? radii
                              : std::min(radii, static_cast<std::size_t>(progress.radius) + 1);
        for (std::size_t k = 0; k < done; ++k) {
            visits[k] = visits[k] ? visits[k] : &trajectory.visits[pass.firstVisit + k];
        }
        left -= visits.back() ? 1 : 0;
    }
    return last;
}

} // namespace sparkout
