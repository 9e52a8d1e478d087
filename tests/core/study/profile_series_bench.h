// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "core/study/profile_series.h"
#include "tests/two_stage_projects.h"

#include <cmath>
#include <optional>

/// The profiles of cycles run for it.
namespace sparkout::profile_series_bench {

using fixtures::traverseProject;

inline Project plungeProject(int sections) {
    Project p = fixtures::plungeProject(sections);
    p.machine->geometric_runout_um = 0.5;
    return p;
}

inline Project boreProject(int sections) {
    Project p = plungeProject(sections);
    p.part->surface = Surface::internal;
    p.wheel->diameter_mm = 20;
    return p;
}

struct Ran {
    SimulationResult result;
    Trajectory trajectory;
};

inline Ran run(const Project& project) {
    Ran ran;
    if (!hasErrors(validate(project))) {
        ran.result = simulate(project, &ran.trajectory);
    }
    return ran;
}

inline ProfileSeries series(const Project& project, std::optional<int> stroke = {}) {
    const Ran ran = run(project);
    return makeProfileSeries(ran.result, ran.trajectory,
                             stroke ? std::optional(progressAfter(ran.trajectory, *stroke))
                                    : std::nullopt);
}

inline double distance(const ProfilePoint& p) {
    return std::hypot(p.x, p.y);
}

inline bool close(double a, double b, double within = 1e-12) {
    return std::abs(a - b) <= within;
}

} // namespace sparkout::profile_series_bench
