// SPDX-License-Identifier: GPL-3.0-or-later
// The cycle of two stages that many tests grind.
#pragma once

#include "tests/whole_project.h"

#include <vector>

namespace sparkout::fixtures {

inline Project traverseProject() {
    Project p;
    p.part->tolerance.radial_runout_um = 6;
    p.machine->compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
    p.machine->dwell_entry_s = 0.333;
    p.machine->dwell_exit_s = 0.333;
    Stage rough, fine;
    rough.radial_feed_mm = 0.004;
    rough.axial_feed_mm_min = 1800;
    rough.stock_mm = 0.110;
    fine.radial_feed_mm = 0.001;
    fine.axial_feed_mm_min = 300;
    fine.stock_mm = 0.040;
    p.cycle->stages = {rough, fine};
    return p;
}

inline Project plungeProject(int sections) {
    Project p = traverseProject();
    p.operation = Operation::plunge;
    p.sections = sections;
    p.part->length_mm = 40;
    p.machine->compliance_mm_per_n = std::vector<double>(static_cast<std::size_t>(sections), 2e-5);
    Stage rough, fine;
    rough.radial_feed_mm_min = 0.5;
    rough.stock_mm = 0.110;
    fine.radial_feed_mm_min = 0.15;
    fine.stock_mm = 0.040;
    p.cycle->stages = {rough, fine};
    return p;
}

} // namespace sparkout::fixtures
