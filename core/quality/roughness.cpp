// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/roughness.h"

#include "core/project/measured.h"
#include "core/project/wheel.h"
#include "core/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

constexpr double isakov = 0.2;
constexpr double structureOf0 = 62; ///< grain share of structure 0 [%]
constexpr double perStep = 0.5;     ///< structure numbers for one percent of grain

} // namespace

RoughnessModel::RoughnessModel(const Project& project)
    : m_cutting(cuttingOf(project))
    , m_grain(project.wheel->grain_mm)
    , m_grainShare(project.wheel->grain_share)
    , m_tipAngle_deg(project.wheel->grain_tip_angle_deg)
    , m_chipping(project.wheel->dressing_chipping_mm)
    , m_factor(project.wheel->roughness_factor)
    , m_structure(perStep * (structureOf0 - 100 * m_grainShare))
    , m_profile(m_grain / std::tan(m_tipAngle_deg * std::numbers::pi / 180)
                * std::sqrt(m_chipping / (4 * m_structure))) {}

void RoughnessModel::stateGrain(FormulaSheet* sheet) const {
    state(
        sheet, "{N_s} = {k}·({N_0} − 100·{W_g})", {"N_s", m_structure, ""},
        {constantTerm("k", perStep), constantTerm("N_0", structureOf0), {"W_g", m_grainShare, ""}});
    state(sheet, "{G} = {d_g}/tg({φ})·√({Δ}/(4·{N_s}))", {"G", m_profile, "mm^1.5"},
          {{"d_g", m_grain, "mm"},
           {"φ", m_tipAngle_deg, "°"},
           {"Δ", m_chipping, "mm"},
           {"N_s", m_structure, ""}});
}

double RoughnessModel::roughness(double a, FormulaSheet* sheet) const {
    const double De = m_cutting.De_mm, eta = m_cutting.dullness;
    const double s = std::numbers::pi * m_cutting.Vd_mm_s / m_cutting.Vk_mm_s * std::sqrt(a / De);
    // √(η + s) − √η without the difference of near numbers
    const double opened = s > 0 ? s / (std::sqrt(eta + s) + std::sqrt(eta)) : 0;
    const double rows = std::cbrt(m_profile * opened);
    const double Ra = m_factor * isakov * rows * rows;
    if (sheet) {
        stateGrain(sheet);
        state(sheet, "{s} = π·{V_d}/{V_k}·√({a}/{D_e})", {"s", s, ""},
              {{"V_d", m_cutting.Vd_mm_s, "mm/s"},
               {"V_k", m_cutting.Vk_mm_s, "mm/s"},
               {"a", a, "mm"},
               {"D_e", De, "mm"}});
        state(sheet, "{Ra} = {f}·{c}·({G}·(√({η} + {s}) − √({η})))^(2/3)", {"Ra", Ra, "mm"},
              {{"f", m_factor, ""},
               constantTerm("c", isakov),
               {"G", m_profile, "mm^1.5"},
               {"η", eta, ""},
               {"s", s, ""}});
    }
    return Ra;
}

double RoughnessModel::limitDepth(double Ra, FormulaSheet* sheet) const {
    const double De = m_cutting.De_mm, eta = m_cutting.dullness;
    const double rows = Ra / (m_factor * isakov);
    const double y = rows * std::sqrt(rows) / m_profile;
    const double s = y * (y + 2 * std::sqrt(eta));
    const double rootShare = s * m_cutting.Vk_mm_s / (std::numbers::pi * m_cutting.Vd_mm_s);
    const double a = De * rootShare * rootShare;
    if (sheet) {
        stateGrain(sheet);
        state(sheet, "{y} = ({Ra}/({f}·{c}))^(3/2)/{G}", {"y", y, ""},
              {{"Ra", Ra, "mm"},
               {"f", m_factor, ""},
               constantTerm("c", isakov),
               {"G", m_profile, "mm^1.5"}});
        state(sheet, "{s} = {y}·({y} + 2·√({η}))", {"s", s, ""}, {{"y", y, ""}, {"η", eta, ""}});
        state(sheet, "{a} = {D_e}·({s}·{V_k}/(π·{V_d}))²", {"a", a, "mm"},
              {{"D_e", De, "mm"},
               {"s", s, ""},
               {"V_k", m_cutting.Vk_mm_s, "mm/s"},
               {"V_d", m_cutting.Vd_mm_s, "mm/s"}});
        state(sheet, "{S_ф} = {a}·{n}", {"S_ф", a * m_cutting.n_rpm, "mm/min"},
              {{"a", a, "mm"}, {"n", m_cutting.n_rpm, "rev/min"}});
    }
    return a;
}

bool isRoughnessCalibrated(const Project& project) {
    const auto isOfRoughness = [](const Calibration& calibration) {
        return calibration.input == "/wheel/roughness_factor";
    };
    return project.wheel->roughness_factor != 1
           || (project.measured
               && std::ranges::any_of(project.measured->calibrations, isOfRoughness));
}

FormulaSheet roughnessSheet(const Project& project, double a) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Roughness"), "MODEL-8", {}};
    stateContact(&sheet, project, cuttingOf(project));
    RoughnessModel(project).roughness(a, &sheet);
    return sheet;
}

FormulaSheet roughnessLimitSheet(const Project& project, double Ra) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Limiting feed, roughness"), "MODEL-8", {}};
    stateContact(&sheet, project, cuttingOf(project));
    RoughnessModel(project).limitDepth(Ra, &sheet);
    return sheet;
}

} // namespace sparkout
