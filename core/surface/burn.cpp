// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/burn.h"

#include "core/project/material.h"
#include "core/surface/rising_root.h"
#include "core/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sparkout {

namespace {

using Wide = long double;

// The difference loses a factor of about 4x² + 1: with 64 bits of mantissa 1e-17 are left at x = 5.
static_assert(std::numeric_limits<Wide>::digits >= 64, "ierfc needs an extended long double");
constexpr double largestDifference = 5;

Wide difference(Wide x) {
    return std::exp(-x * x) * std::numbers::inv_sqrtpi_v<Wide> - x * std::erfc(x);
}

// The repeated integrals of erfc obey 2n·iⁿerfc = iⁿ⁻²erfc − 2x·iⁿ⁻¹erfc, and their ratios r_n =
// iⁿerfc/iⁿ⁻¹erfc the continued fraction r_(n−1) = 1/(2x + 2n·r_n), all of it positive; from
// i⁻¹erfc = 2/√π·e^(−x²), ierfc = 2/√π·e^(−x²)·r_0·r_1.
Wide continuedFraction(Wide x) {
    constexpr int terms = 24; // 1e-19 at x = 5
    Wide r = 1 / (2 * x);
    for (int n = terms; n >= 2; --n) {
        r = 1 / (2 * x + 2 * n * r);
    }
    const Wide r0 = 1 / (2 * x + 2 * r);
    return 2 * std::numbers::inv_sqrtpi_v<Wide> * std::exp(-x * x) * r0 * r;
}

Wide wideIerfc(Wide x) {
    return x < largestDifference ? difference(x) : continuedFraction(x);
}

constexpr double sqrtPi = 1 / std::numbers::inv_sqrtpi;

/// Beyond it ierfc is subnormal.
constexpr double largestArgument = 26;

} // namespace

double ierfc(double x) {
    return static_cast<double>(wideIerfc(x));
}

// Newton's steps on ln ierfc(x) = ln(value). ierfc is log-concave, so from the right they approach
// the root without passing it; e^(−x²)/√π ≥ ierfc(x) gives the start.
double inverseIerfc(double value) {
    constexpr double top = std::numbers::inv_sqrtpi;
    if (value >= top) {
        return 0;
    }
    double x = std::sqrt(std::log(top / value));
    for (int step = 0; step < 100; ++step) {
        const Wide y = wideIerfc(x);
        const Wide slope = std::erfc(static_cast<Wide>(x)) / y;
        const double next = static_cast<double>(x + std::log(y / value) / slope);
        if (!(next < x) || next <= 0) {
            break;
        }
        x = next;
    }
    return x;
}

BurnModel::BurnModel(const Project& project)
    : m_cutting(cuttingOf(project))
    , m_lambda(project.material->conductivity_w_mk) // W/(m·K) = N/(s·K)
    , m_Omega(project.material->diffusivity_mm2_s)
    , m_share(project.material->heat_share) {
    const double De = m_cutting.De_mm, Vd = m_cutting.Vd_mm_s;
    m_surface = 2 * m_share * m_cutting.Vk_mm_s * std::sqrt(m_Omega)
                / (m_lambda * std::sqrt(std::numbers::pi * Vd) * std::sqrt(std::sqrt(De)));
    m_diffusion = std::sqrt(m_Omega * std::sqrt(De) / Vd);
}

Heating BurnModel::heating(double a) const {
    const double De = m_cutting.De_mm, Vd = m_cutting.Vd_mm_s, Vk = m_cutting.Vk_mm_s;
    const double u = std::sqrt(a);
    Heating heat;
    heat.length_mm = std::sqrt(a * De);
    heat.time_s = heat.length_mm / Vd;
    heat.lineForce_n_mm = m_cutting.law.tangential(1, u);
    // P_z/L with √a cancelled, so that a = 0 has its flux, too
    heat.flux_mw_mm2 =
        (m_cutting.law.kt * u + m_cutting.law.mu * m_cutting.law.kr) * Vk / std::sqrt(De);
    heat.diffusionDepth_mm = std::sqrt(m_Omega * heat.time_s);
    heat.scale_k = 2 * m_share * heat.flux_mw_mm2 * heat.diffusionDepth_mm / m_lambda;
    return heat;
}

double BurnModel::rise(double h, double a) const {
    if (!(a > 0)) {
        return 0;
    }
    const Heating heat = heating(a);
    return heat.scale_k * ierfc(h / (2 * heat.diffusionDepth_mm));
}

double BurnModel::damagedDepth(double a, double U) const {
    if (rise(0, a) <= U) {
        return 0;
    }
    const Heating heat = heating(a);
    return 2 * heat.diffusionDepth_mm * inverseIerfc(U / heat.scale_k);
}

// w³ + p·w = Q with p ≥ 0, Q > 0: the difference of Cardano's S − p/(3S), S = ∛(Q/2 + √(Q²/4 +
// p³/27)), is multiplied out with S³ − (p/3S)³ = Q, so that nothing cancels.
double BurnModel::rootOfCubic(double rise, FormulaSheet* sheet) const {
    const ForceLaw& law = m_cutting.law;
    const double p = law.mu * law.kr / law.kt;
    const double Q = rise / (m_surface * law.kt);
    const double S = std::cbrt(Q / 2 + std::hypot(Q / 2, p / 3 * std::sqrt(p / 3)));
    const double w = Q / (S * S + p / 3 + (p / 3 / S) * (p / 3 / S));
    if (sheet) {
        state(sheet, "{c} = 2·{ε_w}·{V_k}·√({Ω})/({λ}·√(π·{V_d})·√(√({D_e})))",
              {"c", m_surface, "K·mm^1.25/N"},
              {{"ε_w", m_share, ""},
               {"V_k", m_cutting.Vk_mm_s, "mm/s"},
               {"Ω", m_Omega, "mm²/s"},
               {"λ", m_lambda, "W/(m·K)"},
               {"V_d", m_cutting.Vd_mm_s, "mm/s"},
               {"D_e", m_cutting.De_mm, "mm"}});
        state(sheet, "{p} = {μ}·{k_r}/{k_t}", {"p", p, "mm^0.5"},
              {{"μ", law.mu, ""}, {"k_r", law.kr, "N/mm^1.5"}, {"k_t", law.kt, "MPa"}});
        state(sheet, "{Q} = {T}/({c}·{k_t})", {"Q", Q, "mm^0.75"},
              {{"T", rise, "K"}, {"c", m_surface, "K·mm^1.25/N"}, {"k_t", law.kt, "MPa"}});
        state(sheet, "{S} = ∛({Q}/2 + √({Q}²/4 + {p}³/27))", {"S", S, "mm^0.25"},
              {{"Q", Q, "mm^0.75"}, {"p", p, "mm^0.5"}});
        state(sheet, "{w} = {Q}/({S}² + {p}/3 + ({p}/(3·{S}))²)", {"w", w, "mm^0.25"},
              {{"Q", Q, "mm^0.75"}, {"S", S, "mm^0.25"}, {"p", p, "mm^0.5"}});
        state(sheet, "{a} = {w}⁴", {"a", w * w * w * w, "mm"}, {{"w", w, "mm^0.25"}});
    }
    return w;
}

double BurnModel::burnFreeDepth(double U, FormulaSheet* sheet) const {
    const double w = rootOfCubic(U, sheet);
    return w * w * w * w;
}

// T(h) = U for the x = h/(2√(Ωτ)) of the contact itself is the cubic with U/(√π·ierfc(x)) on its
// right side. Its root w rises with x,
//     w'/w = (k_t·w² + μk_r)/(3k_t·w² + μk_r)·erfc(x)/ierfc(x),
// and so do √a = w² and the depth h = 2·x·√(Ωτ) = 2·x·diffusion·w.
BurnLimitPoint BurnModel::limitPoint(double U, double x) const {
    const double kt = m_cutting.law.kt, mukr = m_cutting.law.mu * m_cutting.law.kr;
    const double y = ierfc(x);
    const double w = rootOfCubic(U / (sqrtPi * y));
    const double ktw2 = kt * w * w;
    const double slope = w * (ktw2 + mukr) / (3 * ktw2 + mukr) * std::erfc(x) / y;
    return {2 * x * m_diffusion * w, w * w, 2 * m_diffusion * (w + x * slope), 2 * w * slope};
}

double BurnModel::limitArgument(double U, double stock) const {
    if (!(stock > 0)) {
        return 0;
    }
    const double farthest = std::min(largestArgument, stock / (2 * m_diffusion * rootOfCubic(U)));
    return risingRoot(
        [&](double x) {
            const BurnLimitPoint point = limitPoint(U, x);
            return ValueAndSlope{std::log(point.stock_mm / stock),
                                 point.stockSlope_mm / point.stock_mm};
        },
        0, farthest);
}

double BurnModel::limitDepth(double U, double stock, FormulaSheet* sheet) const {
    const double x = limitArgument(U, stock);
    if (!(x > 0)) {
        return burnFreeDepth(U, sheet);
    }
    const double T = U / (sqrtPi * ierfc(x));
    if (sheet) {
        state(sheet, "{x} = {h}/(2·{√(Ωτ)})", {"x", x, ""},
              {{"h", stock, "mm"}, {"√(Ωτ)", m_diffusion * rootOfCubic(T), "mm"}});
        state(sheet, "{T} = {U}/(√(π)·ierfc({x}))", {"T", T, "K"}, {{"U", U, "K"}, {"x", x, ""}});
    }
    const double w = rootOfCubic(T, sheet);
    return w * w * w * w;
}

FormulaSheet burnLimitSheet(const Project& project, double U, double stock) {
    FormulaSheet sheet =
        beginTangential(project, SPARKOUT_NOOP("Formula", "Limiting depth of cut, burn"));
    BurnModel(project).limitDepth(U, stock, &sheet);
    return sheet;
}

} // namespace sparkout
