// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>

namespace sparkout {

/// The workpiece material as the force law and the heat model see it.
struct Material {
    std::string grade;
    std::optional<double> hardness_hrc; ///< [HRC]
    double flow_stress_mpa = 2000;      ///< σ_i, stress intensity [N/mm²]
    double shear_factor = 1.9;          ///< ε_i·tg β
    double shear_strain = 2.8;          ///< ε_i
    double friction = 0.3;              ///< μ
    double conductivity_w_mk = 36;      ///< λ [W/(m·K)]
    double diffusivity_mm2_s = 9;       ///< Ω [mm²/s]
    std::optional<double> burn_rise_k;  ///< U_burn, temperature rise that burns [K]
    double heat_share = 1;              ///< ε_w, share of the heat that goes into the part
};

template <>
const StructInfo& tableOf<Material>();

} // namespace sparkout
