// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/self_sharpening.h"

#include "core/project/wheel.h"
#include "core/text.h"
#include "core/units.h"

#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

constexpr double dullingShare = 0.25; ///< share of the critical force up to which grains only dull
constexpr double grainCrack = 2;      ///< d_g over the grain's crack length
constexpr double bondCrack = 1.7;     ///< D_b over the bridge's crack length
constexpr double joules_m2 = 1e-3;    ///< J/m² in N/mm

/// The four strengths, in N and mm.
struct Strengths {
    double grainEnergy, grainModulus, bondEnergy, bondModulus;
};

std::optional<Strengths> strengths(const Wheel& wheel) {
    if (!wheel.grain_surface_energy_j_m2 || !wheel.grain_modulus_gpa
        || !wheel.bond_surface_energy_j_m2 || !wheel.bond_modulus_gpa) {
        return {};
    }
    return Strengths{
        *wheel.grain_surface_energy_j_m2 * joules_m2, *wheel.grain_modulus_gpa * units::mpaPerGpa,
        *wheel.bond_surface_energy_j_m2 * joules_m2, *wheel.bond_modulus_gpa * units::mpaPerGpa};
}

void lattice(SelfSharpening& s, const Wheel& wheel, FormulaSheet* sheet) {
    const double dg = wheel.grain_mm, Wg = wheel.grain_share, Wb = wheel.bond_share;
    const double edge = std::cbrt(Wg);
    if (wheel.bond_bridge_mm) {
        s.bridge_mm = *wheel.bond_bridge_mm;
        s.bridgeArea_mm2 = std::numbers::pi * s.bridge_mm * s.bridge_mm / 4;
        state(sheet, "{S_b} = π·{D_b}²/4", {"S_b", s.bridgeArea_mm2, "mm²"},
              {{"D_b", s.bridge_mm, "mm"}});
    } else {
        s.bridgeArea_mm2 = dg * dg * Wb / (3 * edge * edge * (1 - edge));
        s.bridge_mm = std::sqrt(4 * s.bridgeArea_mm2 / std::numbers::pi);
        state(sheet, "{S_b} = {d_g}²·{W_b}/(3·{W_g}^(2/3)·(1 − {W_g}^(1/3)))",
              {"S_b", s.bridgeArea_mm2, "mm²"},
              {{"d_g", dg, "mm"}, {"W_b", Wb, ""}, {"W_g", Wg, ""}});
        state(sheet, "{D_b} = √(4·{S_b}/π)", {"D_b", s.bridge_mm, "mm"},
              {{"S_b", s.bridgeArea_mm2, "mm²"}});
    }
    s.grains_mm2 = wheel.grains_per_mm2.value_or(edge * edge / (dg * dg));
    if (!wheel.grains_per_mm2) {
        state(sheet, "{n_g} = {W_g}^(2/3)/{d_g}²", {"n_g", s.grains_mm2, "1/mm²"},
              {{"W_g", Wg, ""}, {"d_g", dg, "mm"}});
    }
}

void criticalForce(SelfSharpening& s, double dg, const Strengths& given, FormulaSheet* sheet) {
    s.grainForce_n = dg * dg * std::sqrt(grainCrack * given.grainEnergy * given.grainModulus / dg);
    s.bondForce_n = s.bridgeArea_mm2
                    * std::sqrt(bondCrack * given.bondEnergy * given.bondModulus / s.bridge_mm);
    s.criticalForce_n = -s.grainForce_n * std::expm1(-s.bondForce_n / s.grainForce_n);
    state(sheet, "{f_g} = {d_g}²·√({k}·{γ_g}·{E_g}/{d_g})", {"f_g", s.grainForce_n, "N"},
          {{"d_g", dg, "mm"},
           constantTerm("k", grainCrack),
           {"γ_g", given.grainEnergy, "N/mm"},
           {"E_g", given.grainModulus, "MPa"}});
    state(sheet, "{f_b} = {S_b}·√({k}·{γ_b}·{E_b}/{D_b})", {"f_b", s.bondForce_n, "N"},
          {{"S_b", s.bridgeArea_mm2, "mm²"},
           constantTerm("k", bondCrack),
           {"γ_b", given.bondEnergy, "N/mm"},
           {"E_b", given.bondModulus, "MPa"},
           {"D_b", s.bridge_mm, "mm"}});
    state(sheet, "{f_cr} = {f_g}·(1 − exp(−{f_b}/{f_g}))", {"f_cr", s.criticalForce_n, "N"},
          {{"f_g", s.grainForce_n, "N"}, {"f_b", s.bondForce_n, "N"}});
}

} // namespace

double SelfSharpening::allowedForce(double b, double a) const {
    return b * allowed * std::sqrt(a);
}

double SelfSharpening::load(double a) const {
    return (ks * std::sqrt(a) + kr) / allowed;
}

std::optional<double> SelfSharpening::limitDepth() const {
    if (kr >= allowed) {
        return {};
    }
    const double u = (allowed - kr) / ks;
    return u * u;
}

std::optional<SelfSharpening> selfSharpening(const Project& project, FormulaSheet* sheet) {
    const std::optional<Strengths> given = strengths(*project.wheel);
    if (!given) {
        return {};
    }
    const Cutting cutting = cuttingOf(project);
    SelfSharpening s;
    s.ks = cutting.law.ks;
    s.kr = cutting.law.kr;
    lattice(s, *project.wheel, sheet);
    criticalForce(s, project.wheel->grain_mm, *given, sheet);
    s.allowedPressure_mpa = dullingShare * s.criticalForce_n * s.grains_mm2;
    s.allowed = s.allowedPressure_mpa * std::sqrt(cutting.De_mm);
    state(sheet, "{F} = {k}·{f_cr}·{n_g}·√({D_e})", {"F", s.allowed, "N/mm^1.5"},
          {constantTerm("k", dullingShare),
           {"f_cr", s.criticalForce_n, "N"},
           {"n_g", s.grains_mm2, "1/mm²"},
           {"D_e", cutting.De_mm, "mm"}});
    return s;
}

std::optional<FormulaSheet> selfSharpeningSheet(const Project& project) {
    FormulaSheet sheet{
        SPARKOUT_NOOP("Formula", "Limiting depth of cut, self-sharpening"), "MODEL-8", {}};
    const Cutting cutting = cuttingOf(project);
    stateContact(&sheet, project, cutting);
    stateNormal(&sheet, project, cutting);
    const std::optional<SelfSharpening> s = selfSharpening(project, &sheet);
    if (!s) {
        return {};
    }
    if (const std::optional<double> a = s->limitDepth()) {
        state(&sheet, "{a} = (({F} − {k_r})/{k_s})²", {"a", *a, "mm"},
              {{"F", s->allowed, "N/mm^1.5"}, {"k_r", s->kr, "N/mm^1.5"}, {"k_s", s->ks, "MPa"}});
    }
    return sheet;
}

} // namespace sparkout
