// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/power.h"

#include "core/project/wheel.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
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

PowerModel::PowerModel(const Project& project) : m_cutting(cuttingOf(project)) {}

PowerModel::Drive PowerModel::wheelDrive() const {
    return {m_cutting.Vk_mm_s, "V_k", "{N_k} = {P_z}·{V_k}", "N_k", "{F} = {N_k}/({b}·{V_k})"};
}

PowerModel::Drive PowerModel::workDrive() const {
    return {m_cutting.Vd_mm_s, "V_d", "{N_d} = {P_z}·{V_d}", "N_d", "{F} = {N_d}/({b}·{V_d})"};
}

double PowerModel::tangential(double b, double a, FormulaSheet* sheet) const {
    stateTangentialForce(sheet, m_cutting.law, b, a);
    return m_cutting.law.tangential(b, std::sqrt(a));
}

double PowerModel::power(const Drive& drive, double b, double a, FormulaSheet* sheet) const {
    const double Pz = tangential(b, a, sheet);
    const double N = Pz * drive.speed;
    state(sheet, drive.powerText, {drive.powerSymbol, N, "mW"},
          {{"P_z", Pz, "N"}, {drive.speedSymbol, drive.speed, "mm/s"}});
    return N;
}

// Solves k_t·u² + μ·k_r·u = F for u = √a by the form of the root without cancellation.
double PowerModel::limitDepth(const Drive& drive, double b, double power,
                              FormulaSheet* sheet) const {
    const double kt = m_cutting.law.kt, mu = m_cutting.law.mu, kr = m_cutting.law.kr;
    const double F = power / (b * drive.speed);
    const double m = mu * kr;
    state(sheet, drive.forceText, {"F", F, "N/mm"},
          {{drive.powerSymbol, power, "mW"},
           {"b", b, "mm"},
           {drive.speedSymbol, drive.speed, "mm/s"}});
    if (m_cutting.law.threshold) {
        const double a = std::max(0.0, F - m) / kt;
        state(sheet, F > m ? "{a} = ({F} − {μ}·{F′_0})/{K_z}" : "{a}", {"a", a, "mm"},
              {{"F", F, "N/mm"}, {"μ", mu, ""}, {"F′_0", kr, "N/mm"}, {"K_z", kt, "MPa"}});
        return a;
    }
    const double u = 2 * F / (m + std::sqrt(m * m + 4 * kt * F));
    state(sheet, "{a} = (2·{F}/({μ}·{k_r} + √(({μ}·{k_r})² + 4·{k_t}·{F})))²", {"a", u * u, "mm"},
          {{"F", F, "N/mm"}, {"μ", mu, ""}, {"k_r", kr, "N/mm^1.5"}, {"k_t", kt, "MPa"}});
    return u * u;
}

double PowerModel::wheelPower(double b, double a, FormulaSheet* sheet) const {
    return power(wheelDrive(), b, a, sheet);
}

double PowerModel::workPower(double b, double a, FormulaSheet* sheet) const {
    return power(workDrive(), b, a, sheet);
}

double PowerModel::wheelLimitDepth(double b, double power, FormulaSheet* sheet) const {
    return limitDepth(wheelDrive(), b, power, sheet);
}

double PowerModel::workLimitDepth(double b, double power, FormulaSheet* sheet) const {
    return limitDepth(workDrive(), b, power, sheet);
}

double PowerModel::specificEnergy(double a) const {
    return power(wheelDrive(), 1, a, nullptr) / (a * m_cutting.Vd_mm_s);
}

FormulaSheet wheelPowerSheet(const Project& project, double b, double a) {
    FormulaSheet sheet =
        beginTangential(project, SPARKOUT_NOOP("Formula", "Power of the wheel drive"));
    PowerModel(project).wheelPower(b, a, &sheet);
    return sheet;
}

FormulaSheet workPowerSheet(const Project& project, double b, double a) {
    FormulaSheet sheet =
        beginTangential(project, SPARKOUT_NOOP("Formula", "Power of the work drive"));
    PowerModel(project).workPower(b, a, &sheet);
    return sheet;
}

FormulaSheet wheelPowerLimitSheet(const Project& project, double b, double power) {
    FormulaSheet sheet =
        beginTangential(project, SPARKOUT_NOOP("Formula", "Limiting depth of cut, wheel drive"));
    PowerModel(project).wheelLimitDepth(b, power, &sheet);
    return sheet;
}

FormulaSheet workPowerLimitSheet(const Project& project, double b, double power) {
    FormulaSheet sheet =
        beginTangential(project, SPARKOUT_NOOP("Formula", "Limiting depth of cut, work drive"));
    PowerModel(project).workLimitDepth(b, power, &sheet);
    return sheet;
}

} // namespace sparkout
