// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/whole_project.h"

namespace sparkout::fixtures {

/// The project held to every requirement of the drawing and of the process: form and roughness,
/// burn, both drives, the strengths of grain and bond.
inline sparkout::Project demanding(sparkout::Project p) {
    p.material->burn_rise_k = 500;
    p.part->tolerance = {4, 6, 5, 8, 0.8, {}};
    p.machine->wheel_drive_kw = 5;
    p.machine->work_drive_kw = 0.5;
    p.wheel->grain_surface_energy_j_m2 = 1800;
    p.wheel->grain_modulus_gpa = 390;
    p.wheel->bond_surface_energy_j_m2 = 400;
    p.wheel->bond_modulus_gpa = 65;
    return p;
}

} // namespace sparkout::fixtures
