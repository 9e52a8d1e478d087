// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup_run.h"

#include "core/setup/worn_project.h"
#include "core/units.h"

#include <algorithm>
#include <utility>

namespace sparkout {

bool SetupRun::isCompleted(const Setup& setup) const {
    return surfaces.size() == setup.surfaces.size()
           && std::ranges::all_of(surfaces, &SurfaceRun::isCompleted);
}

bool SetupRun::holds(const Setup& setup) const {
    return isCompleted(setup) && std::ranges::all_of(surfaces, &SurfaceRun::holds);
}

SetupRun runSetup(const Setup& setup, const std::stop_token& stop) {
    SetupRun run;
    RemovedMetal removed;
    double cycles_min = 0;
    for (std::size_t i = 0; i < setup.surfaces.size() && !stop.stop_requested(); ++i) {
        WornProject made = wornProject(setup, i, removed);
        if (!made.issues.empty()) {
            run.issues = std::move(made.issues);
            break;
        }
        run.surfaces.push_back(runSurface(setup.surfaces[i].name, made.project, stop));
        removed += run.surfaces.back().removed();
        cycles_min += run.surfaces.back().result.time_s / units::secondsPerMinute;
    }
    if (run.isCompleted(setup)) {
        run.time = pieceTime(setup.times, setup.surfaces.size(), cycles_min);
    }
    return run;
}

} // namespace sparkout
