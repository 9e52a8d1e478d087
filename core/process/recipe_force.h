// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/force.h"

namespace sparkout {

/// What the force by a wheel's recipe needs beside the wheel's grain size and shares of volume
/// [PEREVERZEV1999, eq. 1–7]. None of it is found in catalogues.
struct ForceRecipe {
    double contactFactor = 1;   ///< k_Y, of the conditions of grinding
    double grainsPerMm = 1;     ///< m_D, cutting grains on a mm of the circumference [1/mm]
    double cutWidth_mm = 0.01;  ///< b_j, width of a grain's cut [mm]
    double flatLength_mm = 0;   ///< l_g, length of a grain's wear flat [mm]
    double shearAngle_deg = 30; ///< β_1 [°]
};

/// What a recipe comes to in the law of MODEL-2: its sum over the grains in contact,
///
///     P_y = N·b_j·( ε_i·tg β·σ_i·a_k/sin β_1 + σ_i·l_g/3 ),   N = n_c·b·L,
///     n_c = k_Y·W_g·W_b/((1 − W_g − W_b)·d_g²),   a_k = 2·(V_d/V_k)·√(a/D_e)/m_D,   L = √(a·D_e)
///
/// is b·(κ·k_s·a + k_r·√a) with
///
///     κ = 2·b_j·n_c/(m_D·sin β_1),   η = l_g·b_j·n_c.
///
/// Where the chips of the grains are together the metal that the wheel takes off, κ = 1 and the two
/// laws are one; η is then the share of wear flats on the working surface, as its name says.
struct RecipeShares {
    double cuttingGrains_mm2 = 0; ///< n_c [1/mm²]
    double shear = 1;             ///< κ
    double dullness = 0;          ///< η
};

[[nodiscard]] RecipeShares recipeShares(const Project& project, const ForceRecipe& recipe);

/// The law of a project with the wheel's recipe in place of its dullness.
[[nodiscard]] ForceLaw forceLawOf(const Project& project, const ForceRecipe& recipe);

/// The width of a grain's cut at which κ = 1 [mm].
[[nodiscard]] double balancedCutWidth(const Project& project, const ForceRecipe& recipe);

} // namespace sparkout
