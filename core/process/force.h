// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

enum class Surface; // core/project/part.h

/// D_e = dD/(D + d) external, dD/(d − D) internal [mm] [MODEL-1].
[[nodiscard]] double equivalentDiameter(double d, double D, Surface surface);

/// The one force law of cylindrical grinding [MODEL-2, KORCHAK]:
///
///     P_y(a) = b·( k_s·a + k_r·√a )             normal force [N]
///     P_z(a) = b·( k_t·a + μ·k_r·√a )           tangential force [N]
///
/// b effective width of cut [mm], a depth of cut [mm]; valid for a ≥ 0. By the wheel's recipe κ,
/// see RecipeShares, stands before k_s and k_t.
struct ForceLaw {
    double ks = 0; ///< k_s = ε_i·tg β·σ_i·V_d/V_k [N/mm²]
    double kr = 0; ///< k_r = η·σ_i·√D_e/3 [N/mm^1.5]
    double kt = 0; ///< k_t = ε_i·σ_i·V_d/V_k [N/mm²]
    double mu = 0; ///< μ

    /// P_y for u = √a [√mm].
    [[nodiscard]] double normal(double b, double u) const { return b * (ks * u * u + kr * u); }
    /// P_z for u = √a [√mm].
    [[nodiscard]] double tangential(double b, double u) const {
        return b * (kt * u * u + mu * kr * u);
    }
    /// The sums of P_y and P_z of sections of one width b, for Σa [mm] and Σu [√mm].
    [[nodiscard]] double normalOfAll(double b, double a, double u) const {
        return b * (ks * a + kr * u);
    }
    [[nodiscard]] double tangentialOfAll(double b, double a, double u) const {
        return b * (kt * a + mu * kr * u);
    }
};

/// The law of a project's part, material, wheel and speeds.
[[nodiscard]] ForceLaw forceLaw(const Project& project);

} // namespace sparkout
