// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/estimates.h"

#include "core/project/project.h"

#include <initializer_list>

namespace sparkout {

namespace {

template <class T>
void add(std::vector<const Field*>& to, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        to.push_back(tableOf<T>().find(key));
    }
}

} // namespace

std::vector<const Field*> estimatesBehind(ConstraintKind kind) {
    if (scopeOf(kind) == ConstraintScope::setting) {
        return {};
    }
    std::vector<const Field*> fields;
    add<Material>(fields, {"flow_stress_mpa"});
    add<Wheel>(fields, {"dullness"});
    add<Machine>(fields, {"compliance_mm_per_n"});
    switch (kind) {
    case ConstraintKind::roughness:
        add<Wheel>(fields, {"grain_tip_angle_deg", "dressing_chipping_mm", "roughness_factor"});
        break;
    case ConstraintKind::burn:
        add<Material>(fields, {"friction", "burn_rise_k", "heat_share"});
        break;
    case ConstraintKind::selfSharpening:
        add<Wheel>(fields, {"grain_surface_energy_j_m2", "grain_modulus_gpa",
                            "bond_surface_energy_j_m2", "bond_modulus_gpa"});
        break;
    case ConstraintKind::wheelPower:
    case ConstraintKind::workPower: add<Material>(fields, {"friction"}); break;
    default: break;
    }
    return fields;
}

} // namespace sparkout
