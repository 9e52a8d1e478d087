// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/cutting.h"

#include <optional>

namespace sparkout {

/// The wheel's critical force, Umino's lattice with Griffith strengths [MODEL-8, PEREVERZEV1999 23,
/// 24]. Above a quarter of it the wheel sheds or breaks its grains:
///
///     S_b = d_g²·W_b/(3·W_g^⅔·(1 − W_g^⅓)),  D_b = √(4·S_b/π),  n_g = W_g^⅔/d_g²
///     f_g = d_g²·√(2·γ_g·E_g/d_g),  f_b = S_b·√(1.7·γ_b·E_b/D_b),  f_cr = f_g·(1 − e^(−f_b/f_g))
///     P_y ≤ 0.25·f_cr·n_g·b·L,  hence  √a ≤ (F − k_r)/k_s  with  F = 0.25·f_cr·n_g·√D_e
///
/// A D_b or n_g of the project replaces the lattice's; S_b remains that of the lattice.
struct SelfSharpening {
    double bridgeArea_mm2 = 0;      ///< S_b
    double bridge_mm = 0;           ///< D_b
    double grains_mm2 = 0;          ///< n_g [1/mm²]
    double grainForce_n = 0;        ///< f_g
    double bondForce_n = 0;         ///< f_b
    double criticalForce_n = 0;     ///< f_cr, of one grain
    double allowedPressure_mpa = 0; ///< 0.25·f_cr·n_g, on the contact area b·L
    double allowed = 0;             ///< F [N/mm^1.5]
    double ks = 0, kr = 0;          ///< coefficients of P_y

    /// The greatest allowed force in the contact [N]: 0.25·f_cr·n_g·b·L.
    [[nodiscard]] double allowedForce(double b, double a) const;
    /// P_y over the allowed force, the same for every width; rises with a. The check of a pass: ≤ 1
    /// for its largest depth.
    [[nodiscard]] double load(double a) const;
    /// Greatest depth of cut [mm]; empty where k_r ≥ F: not met at any depth.
    [[nodiscard]] std::optional<double> limitDepth() const;
};

/// Empty when a strength of grain or bond is not given: the check is off.
[[nodiscard]] std::optional<SelfSharpening> selfSharpening(const Project& project,
                                                           FormulaSheet* sheet = nullptr);

/// Lattice, critical force and limiting depth; empty when the check is off. Where it is not met at
/// any depth the last step is F, which is not above k_r.
[[nodiscard]] std::optional<FormulaSheet> selfSharpeningSheet(const Project& project);

} // namespace sparkout
