// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <string_view>

namespace sparkout {

/// The force by the wheel's recipe, summed over the grains in contact [PEREVERZEV1999, eq. 1–7]:
/// its inputs besides the wheel's grain size and volume shares. Catalogues have none of them.
struct ForceRecipe {
    double contact_factor = 1;          ///< k_Y, factor of the grinding conditions
    double grains_per_mm = 1;           ///< m_D, cutting grains on the circumference [1/mm]
    double shear_angle_deg = 30;        ///< β_1 [°]
    std::optional<double> cut_width_mm; ///< b_j, width of a grain's cut; not given: the chips add
                                        ///< up to the metal removed
    std::optional<double> wear_flat_mm; ///< l_g of a grain; not given: from the dullness
};

/// Ra of a part ground by this wheel in its dressed state, and the conditions of the measured cut.
struct MeasuredRa {
    double ra_um = 0.8;              ///< Ra [µm]
    std::optional<double> infeed_um; ///< per step of the cycle; not given: the cycle's
    std::optional<double>
        spark_out_steps; ///< revolutions or double strokes; not given: the cycle's
    friend bool operator==(const MeasuredRa&, const MeasuredRa&) = default;
};

/// The wheel out of true since its last dressing, which prints waves onto the work [MODEL-16]: a
/// runout of its surface, or an unbalance that came afterwards, given itself or by its grade.
struct WheelRunout {
    std::optional<double> amplitude_um{};       ///< e, half of the total runout [µm]
    int lobes = 1;                              ///< L of the amplitude
    std::optional<double> unbalance_g_mm{};     ///< U [g·mm]
    std::optional<double> balance_grade_mm_s{}; ///< G = U·ω/M [mm/s]
    std::optional<double> rotor_mass_kg{};      ///< M, for the grade [kg]
    double phase_deg = 0;                       ///< ψ_0 when the cycle begins [°]

    /// Whether an unbalance moves the wheel head, whose stiffness then counts.
    [[nodiscard]] bool isForced() const { return unbalance_g_mm || balance_grade_mm_s; }
    friend bool operator==(const WheelRunout&, const WheelRunout&) = default;
};

/// After an edit of one of its three forms, which replaces the others; a grade without a mass takes
/// an ordinary one.
void keepRunoutForm(std::optional<WheelRunout>& runout, std::string_view key);

/// Highest calibration factor of Ra.
inline constexpr double mostRoughnessFactor = 100;

/// The grinding wheel: size, sharpness, structure.
struct Wheel {
    std::string marking;
    double diameter_mm = 500;          ///< D [mm]
    double width_mm = 50;              ///< B [mm]
    double dullness = 0.02;            ///< η, share of wear flats, 0…1
    double radius_wear_um = 0;         ///< w_k, since the control was last set to its radius [µm]
    double grain_mm = 0.25;            ///< d_g [mm]
    double grain_share = 0.5;          ///< W_g, by volume
    double bond_share = 0.12;          ///< W_b, by volume
    double grain_tip_angle_deg = 45;   ///< φ [°]
    double dressing_chipping_mm = 0.1; ///< Δ, chipping level of dressing [mm]
    double roughness_factor = 1;       ///< calibration of Ra
    std::optional<double> grain_surface_energy_j_m2; ///< γ_g [J/m²]
    std::optional<double> grain_modulus_gpa;         ///< E_g [GPa]
    std::optional<double> bond_surface_energy_j_m2;  ///< γ_b [J/m²]
    std::optional<double> bond_modulus_gpa;          ///< E_b [GPa]
    std::optional<double> bond_bridge_mm;            ///< D_b; not given: from the lattice [mm]
    std::optional<double> grains_per_mm2;            ///< n_g; not given: from the lattice [1/mm²]
    std::optional<double> max_speed_m_s; ///< highest working speed; not given: not limited [m/s]
    std::string dressing;                ///< tool and settings, in words
    std::optional<ForceRecipe> force_recipe; ///< not given: force by η alone
    std::optional<MeasuredRa> measured_ra;   ///< determines the factor of Ra
    std::optional<WheelRunout> runout;       ///< not given: not known
};

/// A wheel's recipe in terms of the force law of MODEL-2: the published sum over the grains in
/// contact [PEREVERZEV1999, eq. 1–7],
///
///     P_y = N·b_j·( ε_i·tg β·σ_i·a_k/sin β_1 + σ_i·l_g/3 ),   N = n_c·b·L,
///     n_c = k_Y·W_g·W_b/((1 − W_g − W_b)·d_g²),   a_k = 2·(V_d/V_k)·√(a/D_e)/m_D,   L = √(a·D_e)
///
/// is b·(κ·k_s·a + k_r·√a) with
///
///     κ = 2·b_j·n_c/(m_D·sin β_1),   η = l_g·b_j·n_c.
///
/// Where the chips of the grains make up the metal removed, κ = 1 and the two
/// laws are one; η is then the share of wear flats on the working surface, as its name says.
struct RecipeShares {
    double cuttingGrains_mm2 = 0; ///< n_c [1/mm²]
    double cutWidth_mm = 0;       ///< b_j [mm]; for κ = 1 if it is not given
    double shear = 1;             ///< κ
    double dullness = 0;          ///< η
};

[[nodiscard]] RecipeShares recipeShares(const Wheel& wheel, const ForceRecipe& recipe);

template <>
const StructInfo& tableOf<ForceRecipe>();
template <>
const StructInfo& tableOf<MeasuredRa>();
template <>
const StructInfo& tableOf<WheelRunout>();
template <>
const StructInfo& tableOf<Wheel>();

/// The contents of a grinding wheel's marking: abrasive, grit, hardness, structure, bond, and
/// optionally sizes before and speed after, such as "1 500×50×203 25А F60 L 6 V 35 м/с" or short
/// "25АF60L6V" [GOSTR52781, ISO525].
struct WheelMarking {
    std::string abrasive;         ///< 25А, 14А, 63С …; in the letters of Russian markings
    int grit = 0;                 ///< F grit number
    char hardness = 0;            ///< A, the softest, to Z
    std::optional<int> structure; ///< structure number
    std::string bond;             ///< V vitrified, B resin, R rubber …; with its reinforcement
    std::optional<double> diameter_mm, width_mm, bore_mm;
    std::optional<double> speed_m_s; ///< highest
};

/// Reads a marking; letters may be Cyrillic or Latin, spaces may be missing. Empty if abrasive,
/// grit, hardness or bond is missing, or if part of the text is not understood.
[[nodiscard]] std::optional<WheelMarking> readWheelMarking(std::string_view text);

/// The marking in its usual spelling, "25А F60 L 6 V", with sizes before and speed after if given.
[[nodiscard]] std::string markingText(const WheelMarking& marking);

/// Mean grain of an F grit from F16 to F220 [mm], empty for others. Rounded standard sizes, an
/// estimate for a single wheel.
[[nodiscard]] std::optional<double> grainOfGrit(int grit);

/// W_g = (62 − 2·N)/100 of structure number N, as N_s = 0.5·(62 − 100·W_g) [MODEL-8].
[[nodiscard]] double grainShareOfStructure(int structure);

/// Fills a wheel from its marking: the marking itself, grain, grain share and sizes as far as
/// given; the rest is unchanged.
void applyMarking(const WheelMarking& marking, Wheel& wheel);

} // namespace sparkout
