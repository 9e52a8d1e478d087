// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

struct Wheel; // core/project/wheel.h

/// η of a wheel: its dullness, or the value that follows from the wear flats of its recipe.
[[nodiscard]] double dullnessOf(const Wheel& wheel);

/// Gives a wheel this η through the input that determines it.
void setDullness(Wheel& wheel, double dullness);

/// The path of that input in a project.
[[nodiscard]] const char* dullnessPath(const Wheel& wheel);

enum class Surface; // core/project/part.h

/// D_e = dD/(D + d) external, dD/(d − D) internal [mm] [MODEL-1].
[[nodiscard]] double equivalentDiameter(double d, double D, Surface surface);

/// The one force law of cylindrical grinding [MODEL-2, KORCHAK]:
///
///     P_y(a) = b·( k_s·a + k_r·√a )             normal force [N]
///     P_z(a) = b·( k_t·a + μ·k_r·√a )           tangential force [N]
///
/// b effective width of cut [mm], a depth of cut [mm]; valid for a ≥ 0. With the wheel's
/// recipe k_s and k_t are multiplied by κ, see RecipeShares.
///
/// With a threshold, as an option [HON585], a width is in one of three states:
///
///     cutting     P_y = b·(F'_0 + K·a),  a > 0      P_z = b·(K_z·a + μ·F'_0)
///     touching    P_y = b·F'_0·v,  0 < v ≤ 1, a = 0      P_z = μ·P_y
///     off         P_y = P_z = 0
///
/// v = min(P_y/(b·F'_0), 1) is the rubbing share, 1 where it cuts. So both laws are
/// P_y = b·(k_s·a + k_r·v), P_z = b·(k_t·a + μ·k_r·v): in the sources' law v is √a; in the law with
/// a threshold k_s, k_r and k_t are K, F'_0 and K_z.
struct ForceLaw {
    double ks = 0;          ///< k_s = ε_i·tg β·σ_i·V_d/V_k; K = K_0·V_d/V_k [N/mm²]
    double kr = 0;          ///< k_r = η·σ_i·√D_e/3 [N/mm^1.5]; F'_0 [N/mm]
    double kt = 0;          ///< k_t = ε_i·σ_i·V_d/V_k; K_z = K_z0·V_d/V_k [N/mm²]
    double mu = 0;          ///< μ
    bool threshold = false; ///< the law with a threshold

    /// v of a depth of cut of u = √a [√mm]: with a threshold that of a width that cuts or is off.
    [[nodiscard]] double rubbing(double u) const { return !threshold ? u : u > 0 ? 1 : 0; }
    /// P_y for u = √a [√mm].
    [[nodiscard]] double normal(double b, double u) const {
        return b * (ks * u * u + kr * rubbing(u));
    }
    /// P_z for u = √a [√mm].
    [[nodiscard]] double tangential(double b, double u) const {
        return b * (kt * u * u + mu * kr * rubbing(u));
    }
    /// P_y and P_z of a depth of cut and its v, or the sums of sections of one width b, for Σa [mm]
    /// and Σv.
    [[nodiscard]] double normalOfAll(double b, double a, double v) const {
        return b * (ks * a + kr * v);
    }
    [[nodiscard]] double tangentialOfAll(double b, double a, double v) const {
        return b * (kt * a + mu * kr * v);
    }
};

/// Whether a project's force has a threshold.
[[nodiscard]] bool hasThreshold(const Project& project);

/// The law of a project's part, material, wheel and speeds.
[[nodiscard]] ForceLaw forceLaw(const Project& project);

} // namespace sparkout
