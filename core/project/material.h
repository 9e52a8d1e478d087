// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>

namespace sparkout {

/// The law of the normal force over the depth of cut [MODEL-2].
enum class ForceLawKind {
    sources,  ///< b·(k_s·a + k_r·√a), the law of the sources
    threshold ///< b·(F'_0 + K·a): nothing is cut below F'_0
};

/// The workpiece material for the force law and the heat model.
struct Material {
    std::string grade;
    std::optional<double> hardness_hrc; ///< [HRC]
    double flow_stress_mpa = 2000;      ///< σ_i, stress intensity [N/mm²]
    double shear_factor = 1.9;          ///< ε_i·tg β
    double shear_strain = 2.8;          ///< ε_i
    double friction = 0.3;              ///< μ
    ForceLawKind force_law = ForceLawKind::sources;
    double threshold_force_n_mm = 0.5;                   ///< F'_0, a width that just cuts [N/mm]
    double specific_force_mpa = 50000;                   ///< K_0, K = K_0·V_d/V_k [N/mm²]
    std::optional<double> specific_tangential_force_mpa; ///< likewise for K_z [N/mm²]
    double conductivity_w_mk = 36;                       ///< λ [W/(m·K)]
    double diffusivity_mm2_s = 9;                        ///< Ω [mm²/s]
    std::optional<double> burn_rise_k; ///< U_burn, temperature rise that burns [K]
    double heat_share = 1;             ///< ε_w, share of the heat that enters the part
    double expansion_um_m_k = 11.5;    ///< α, of length with temperature [µm/(m·K)]
};

template <>
std::span<const Choice> choicesOf<ForceLawKind>();
template <>
const StructInfo& tableOf<Material>();

} // namespace sparkout
