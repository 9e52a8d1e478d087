// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/worn_project.h"

#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/setup/surface_run.h"

#include <algorithm>

namespace sparkout {

WornProject wornProject(const Setup& setup, std::size_t surface, double removed_mm3) {
    WornProject made{surface, setup.surfaces[surface].project, {}};
    if (removed_mm3 > 0 && setup.wear.isGiven()) {
        *made.project.wheel = wheelAfter(*made.project.wheel, setup.wear, removed_mm3);
        made.issues = validate(made.project);
        std::erase_if(made.issues,
                      [](const Issue& issue) { return issue.severity != Severity::error; });
    }
    return made;
}

WornProject wornProject(const Setup& setup, std::size_t surface, const std::stop_token& stop) {
    double removed_mm3 = 0;
    for (std::size_t i = 0; i < surface && setup.wear.isGiven() && !stop.stop_requested(); ++i) {
        WornProject before = wornProject(setup, i, removed_mm3);
        if (!before.issues.empty()) {
            return before;
        }
        removed_mm3 += runSurface({}, before.project, stop).removed_mm3;
    }
    return wornProject(setup, surface, removed_mm3);
}

} // namespace sparkout
