// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/support/project_fixtures.h"

namespace sparkout::fixtures {

/// The shaft with a small grid, of which some cycles hold.
inline Project searchedShaft() {
    Project project = traverse();
    project.optimisation = Optimisation{};
    project.optimisation->stages = {1, 2};
    project.optimisation->stock_step_mm = 0.02;
    project.optimisation->radial_feed_mm = SteppedLevels{0.001, 0.006, 0.001};
    project.optimisation->axial_feed_mm_min = std::vector<double>{300, 1200, 2400};
    return project;
}

/// The same with a grid that takes minutes.
inline Project endlessSearch() {
    Project project = searchedShaft();
    project.part->radii_per_section = 360;
    project.optimisation->stages = {4, 5};
    project.optimisation->stock_step_mm = 0.002;
    project.optimisation->radial_feed_mm = SteppedLevels{0.0005, 0.012, 0.0005};
    project.optimisation->axial_feed_mm_min = SteppedLevels{100, 3600, 100};
    return project;
}

} // namespace sparkout::fixtures
