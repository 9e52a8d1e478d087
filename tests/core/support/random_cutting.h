// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/support/project_fixtures.h"

#include <rapidcheck.h>

#include <cmath>

/// Random contacts of wheel and part for the laws of the depth's limits. Call within rc::check.
namespace sparkout::fixtures {

inline int pick(int low, int high) {
    return *rc::gen::inRange(low, high);
}
inline bool oneIn(int n) {
    return pick(0, n) == 0;
}
inline double between(double low, double high) {
    return low + (high - low) * pick(0, 100'001) / 100'000;
}
inline double decades(double low, double high) {
    return std::pow(10, between(low, high));
}

/// External or internal, sharp or dull, with everything the limits read.
inline Project anyCutting() {
    Project p;
    p.operation = oneIn(2) ? Operation::plunge : Operation::traverse;
    p.part->surface = oneIn(3) ? Surface::internal : Surface::external;
    p.part->diameter_mm = between(5, 200);
    p.wheel->diameter_mm = p.part->surface == Surface::internal
                               ? between(0.3, 0.95) * p.part->diameter_mm
                               : between(100, 900);
    p.wheel->dullness = oneIn(4) ? 0 : decades(-3, -0.5);
    p.wheel->grain_mm = between(0.05, 1);
    p.wheel->grain_share = between(0.3, 0.6);
    p.wheel->bond_share = between(0.02, 0.3);
    p.wheel->grain_tip_angle_deg = between(20, 80);
    p.wheel->dressing_chipping_mm = decades(-3, 0);
    p.wheel->roughness_factor = decades(-1, 1);
    p.material->flow_stress_mpa = between(300, 4000);
    p.material->shear_factor = between(1, 4);
    p.material->shear_strain = between(1, 6);
    p.material->friction = oneIn(6) ? 0 : between(0.1, 0.6);
    p.material->conductivity_w_mk = between(5, 80);
    p.material->diffusivity_mm2_s = between(2, 25);
    p.material->heat_share = between(0.05, 1);
    p.machine->wheel_speed_m_s = between(15, 80);
    p.machine->work_speed_rpm = between(20, 600);
    return p;
}

} // namespace sparkout::fixtures
