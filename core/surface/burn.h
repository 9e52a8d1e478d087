// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/cutting.h"

namespace sparkout {

/// ierfc(x) = ∫ₓ^∞ erfc(t) dt = e^(−x²)/√π − x·erfc(x), x ≥ 0, to 1e-15 of its value for every x
/// where it is a normal number (x < 26). 1/√π at 0, falling, log-concave.
[[nodiscard]] double ierfc(double x);

/// The x ≥ 0 with ierfc(x) = value; 0 for values from 1/√π up. value > 0.
[[nodiscard]] double inverseIerfc(double value);

/// The heat of one depth of cut.
struct Heating {
    double length_mm = 0;         ///< L = √(a·D_e)
    double time_s = 0;            ///< τ = L/V_d
    double lineForce_n_mm = 0;    ///< P_z/b
    double flux_mw_mm2 = 0;       ///< q = P_z·V_k/(b·L); mW/mm² = N/(mm·s)
    double diffusionDepth_mm = 0; ///< √(Ω·τ)
    double scale_k = 0;           ///< 2·ε_w·q·√(Ωτ)/λ; T(0) = scale/√π
};

/// A point of the curve of limiting depths: the stock at which √a = root is just allowed.
struct BurnLimitPoint {
    double stock_mm = 0;
    double root = 0;          ///< √a [√mm]
    double stockSlope_mm = 0; ///< d stock/dx
    double rootSlope = 0;     ///< d√a/dx
};

/// Temperature under the contact, a moving source on a half-space [MODEL-8, PEREVERZEV1999 25]:
///
///     T(h) = 2·ε_w·q·√(Ωτ)/λ · ierfc( h/(2·√(Ωτ)) )        rise above the part's temperature [K]
///
/// h below the fresh surface [mm], a depth of cut [mm]. T rises with a at every h and falls with h;
/// T → 0 with a → 0. With w = a^(1/4) the rise of the surface is a cubic without a square,
///
///     T(0) = c·( k_t·w³ + μ·k_r·w ),   c = 2·ε_w·V_k·√Ω / ( λ·√(π·V_d)·D_e^(1/4) )
///
/// rising in w, so each rise has one positive root. U below is U_burn, the rise that burns [K].
class BurnModel {
public:
    explicit BurnModel(const Project& project);

    Heating heating(double a) const;
    /// T(h) [K]; 0 for a ≤ 0.
    double rise(double h, double a) const;
    /// Depth of the damaged layer h_d [mm]: T(h_d) = U, 0 where T(0) ≤ U.
    double damagedDepth(double a, double U) const;

    /// Greatest depth of cut [mm] that does not burn: T(0) = U, the cubic's root in closed form.
    double burnFreeDepth(double U, FormulaSheet* sheet = nullptr) const;
    /// Greatest depth of cut [mm] whose damaged layer is not deeper than the stock left, h_d ≤
    /// stock: T(stock) = U. It rises with the stock, from burnFreeDepth(U) at 0; so a radius is
    /// within the limit exactly if a ≤ limitDepth(U, max(0, R_k after the pass − R_t)).
    double limitDepth(double U, double stock, FormulaSheet* sheet = nullptr) const;

    /// The curve with x = stock/(2·√(Ωτ)) as its parameter, x ≥ 0, without root finding: the cubic
    /// with U/(√π·ierfc(x)) replacing U.
    [[nodiscard]] BurnLimitPoint limitPoint(double U, double x) const;
    /// The x of a stock.
    [[nodiscard]] double limitArgument(double U, double stock) const;

private:
    double rootOfCubic(double rise, FormulaSheet* sheet = nullptr) const;

    Cutting m_cutting;
    double m_lambda, m_Omega, m_share;
    double m_surface;   ///< c [K·mm^(5/4)/N]
    double m_diffusion; ///< √(Ω·√D_e/V_d), so that √(Ωτ) = diffusion·w [mm^(3/4)]
};

/// The limiting depth for the stock left, with all intermediate values.
[[nodiscard]] FormulaSheet burnLimitSheet(const Project& project, double U, double stock);

} // namespace sparkout
