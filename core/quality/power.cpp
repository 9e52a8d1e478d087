// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/power.h"

#include "core/text.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

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
