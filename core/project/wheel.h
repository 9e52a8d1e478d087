// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>

namespace sparkout {

/// The force by the wheel's recipe, summed over the grains in contact [PEREVERZEV1999, eq. 1–7]:
/// what it needs beside the wheel's grain size and shares of volume. None of it is found in
/// catalogues.
struct ForceRecipe {
    double contact_factor = 1;          ///< k_Y, of the conditions of grinding
    double grains_per_mm = 1;           ///< m_D, cutting grains on the circumference [1/mm]
    double shear_angle_deg = 30;        ///< β_1 [°]
    std::optional<double> cut_width_mm; ///< b_j, of a grain; not given: chips make up the metal
    std::optional<double> wear_flat_mm; ///< l_g, of a grain; not given: as the dullness has it
};

/// The grinding wheel: size, sharpness, structure.
struct Wheel {
    std::string marking;
    double diameter_mm = 500;                        ///< D [mm]
    double width_mm = 50;                            ///< B [mm]
    double dullness = 0.02;                          ///< η, share of wear flats, 0…1
    double grain_mm = 0.25;                          ///< d_g [mm]
    double grain_share = 0.5;                        ///< W_g, by volume
    double bond_share = 0.12;                        ///< W_b, by volume
    double grain_tip_angle_deg = 45;                 ///< φ [°]
    double dressing_chipping_mm = 0.1;               ///< Δ, chipping level of dressing [mm]
    double roughness_factor = 1;                     ///< calibration of Ra
    std::optional<double> grain_surface_energy_j_m2; ///< γ_g [J/m²]
    std::optional<double> grain_modulus_gpa;         ///< E_g [GPa]
    std::optional<double> bond_surface_energy_j_m2;  ///< γ_b [J/m²]
    std::optional<double> bond_modulus_gpa;          ///< E_b [GPa]
    std::optional<double> bond_bridge_mm;            ///< D_b; not given: from the lattice [mm]
    std::optional<double> grains_per_mm2;            ///< n_g; not given: from the lattice [1/mm²]
    std::optional<double> max_speed_m_s; ///< highest working speed; not given: not limited [m/s]
    std::string dressing;                ///< tool and settings, in words
    std::optional<ForceRecipe> force_recipe; ///< not given: the force by η alone
};

template <>
const StructInfo& tableOf<ForceRecipe>();
template <>
const StructInfo& tableOf<Wheel>();

} // namespace sparkout
