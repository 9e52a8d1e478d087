// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/force.h"
#include "core/surface/formula.h"

namespace sparkout {

/// A project's contact of wheel and part, in mm, N, s: the basis of the limits of the depth of cut
/// [MODEL-1, MODEL-2].
struct Cutting {
    ForceLaw law;
    double d_mm = 0;     ///< d, part
    double D_mm = 0;     ///< D, wheel
    double De_mm = 0;    ///< D_e
    double n_rpm = 0;    ///< n
    double Vd_mm_s = 0;  ///< V_d = π·d·n
    double Vk_mm_s = 0;  ///< V_k
    double dullness = 0; ///< η
};

[[nodiscard]] Cutting cuttingOf(const Project& project);

/// Normal force P_y(a) [N] and tangential force P_z(a) [N] for an effective width b [mm], with all
/// intermediate values [MODEL-2, KORCHAK]. With a threshold, for a width that cuts, a > 0.
[[nodiscard]] FormulaSheet normalForceSheet(const Project& project, double b, double a);
[[nodiscard]] FormulaSheet tangentialForceSheet(const Project& project, double b, double a);

/// Shows D_e, V_d and V_k with their numbers, at the beginning of every sheet that needs them.
void stateContact(FormulaSheet* sheet, const Project& project, const Cutting& cutting);
/// μ·k_r and k_t with their numbers.
void stateTangential(FormulaSheet* sheet, const Project& project, const Cutting& cutting);
/// k_s and k_r with their numbers.
void stateNormal(FormulaSheet* sheet, const Project& project, const Cutting& cutting);

/// P_y and P_z themselves.
void stateNormalForce(FormulaSheet* sheet, const ForceLaw& law, double b, double a);
void stateTangentialForce(FormulaSheet* sheet, const ForceLaw& law, double b, double a);

/// A sheet that begins with contact and tangential force.
[[nodiscard]] FormulaSheet beginTangential(const Project& project, const char* name);

} // namespace sparkout
