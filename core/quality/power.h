// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/cutting.h"

namespace sparkout {

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
