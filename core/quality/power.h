// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/cutting.h"

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

/// Power of the drives [MODEL-2, MODEL-8]: the wheel's N_k = P_z·V_k and the work's N_d = P_z·V_d,
/// P_z(a) = b·(k_t·a + μ·k_r·√a); 1 N·mm/s = 1 mW. Both rise with a from 0 on, and their ratio is
/// always V_d/V_k, so the pass with the largest P_z is the worst for both. With a threshold P_z =
/// b·(K_z·a + μ·F'_0) of a cutting width; a drive that this friction alone overloads has the
/// limiting depth 0.
class PowerModel {
public:
    explicit PowerModel(const Project& project);

    /// N_k, N_d [mW] at an effective width b [mm].
    double wheelPower(double b, double a, FormulaSheet* sheet = nullptr) const;
    double workPower(double b, double a, FormulaSheet* sheet = nullptr) const;

    /// Greatest depth of cut [mm] for which the drive's power [mW] is sufficient.
    double wheelLimitDepth(double b, double power, FormulaSheet* sheet = nullptr) const;
    double workLimitDepth(double b, double power, FormulaSheet* sheet = nullptr) const;

    /// Energy of the wheel per volume of metal, P_z·V_k/(b·a·V_d) [mJ/mm³], for a > 0. It falls
    /// with a.
    double specificEnergy(double a) const;

private:
    /// The names of a drive in its sheets.
    struct Drive {
        double speed;
        const char* speedSymbol;
        const char* powerText;
        const char* powerSymbol;
        const char* forceText;
    };
    [[nodiscard]] Drive wheelDrive() const;
    [[nodiscard]] Drive workDrive() const;
    double power(const Drive& drive, double b, double a, FormulaSheet* sheet) const;
    double limitDepth(const Drive& drive, double b, double power, FormulaSheet* sheet) const;
    double tangential(double b, double a, FormulaSheet* sheet) const;

    Cutting m_cutting;
};

[[nodiscard]] FormulaSheet wheelPowerSheet(const Project& project, double b, double a);
[[nodiscard]] FormulaSheet workPowerSheet(const Project& project, double b, double a);
/// Powers in mW.
[[nodiscard]] FormulaSheet wheelPowerLimitSheet(const Project& project, double b, double power);
[[nodiscard]] FormulaSheet workPowerLimitSheet(const Project& project, double b, double power);

} // namespace sparkout
