// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/worn_project.h"

#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/setup/removed_volumes.h"
#include "core/setup/surface_run.h"

#include <algorithm>
#include <optional>

namespace sparkout {

namespace {

Issues errorsOf(const Project& project) {
    Issues issues = validate(project);
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    return issues;
}

} // namespace

WornProject wornProject(const Setup& setup, std::size_t surface, double removed_mm3) {
    WornProject made{surface, setup.surfaces[surface].project, {}, removed_mm3};
    if (removed_mm3 > 0 && setup.wear.isGiven()) {
        *made.project.wheel = wheelAfter(*made.project.wheel, setup.wear, removed_mm3);
        made.issues = errorsOf(made.project);
    }
    return made;
}

WornProject wornProject(const Setup& setup, std::size_t surface, const std::stop_token& stop,
                        RemovedVolumes* known) {
    double removed_mm3 = 0;
    for (std::size_t i = 0; i < surface && setup.wear.isGiven() && !stop.stop_requested(); ++i) {
        WornProject before = wornProject(setup, i, removed_mm3);
        if (removed_mm3 <= 0) { // of a set-up that is unfinished
            before.issues = errorsOf(before.project);
        }
        if (!before.issues.empty()) {
            return before;
        }
        std::optional<double> removed = known ? known->find(before.project) : std::nullopt;
        if (!removed) {
            removed = runSurface({}, before.project, stop).removed_mm3;
            if (known && !stop.stop_requested()) {
                known->add(before.project, *removed);
            }
        }
        removed_mm3 += *removed;
    }
    return wornProject(setup, surface, removed_mm3);
}

} // namespace sparkout
