// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

struct ForceRecipe; // core/project/wheel.h
struct Wheel;

/// What a wheel's recipe comes to in the law of MODEL-2: the published sum over the grains in
/// contact [PEREVERZEV1999, eq. 1–7],
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
    double cutWidth_mm = 0;       ///< b_j [mm]; of κ = 1 where it is not given
    double shear = 1;             ///< κ
    double dullness = 0;          ///< η
};

[[nodiscard]] RecipeShares recipeShares(const Wheel& wheel, const ForceRecipe& recipe);

/// η of a wheel: its dullness, or what the wear flats of its recipe come to.
[[nodiscard]] double dullnessOf(const Wheel& wheel);

/// Gives a wheel this η, by the input that has a say in it.
void setDullness(Wheel& wheel, double dullness);

/// That input: its path in a project.
[[nodiscard]] const char* dullnessPath(const Wheel& wheel);

} // namespace sparkout
