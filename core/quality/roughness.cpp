// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/roughness.h"

#include "core/process/force.h"
#include "core/process/pass_kernel.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/measured.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/limit_series.h"
#include "core/simulation/stage_control.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace sparkout {

namespace {

constexpr double isakov = 0.2;
constexpr double structureOf0 = 62; ///< grain share of structure 0 [%]
constexpr double perStep = 0.5;     ///< structure numbers for one percent of grain

// Estimates. With the usual factor a wheel F60 leaves 0.4…0.8 µm in starting cycles; the influence
// of the grain follows Isakov's law.
constexpr double usualRaFactor = 9.5;
constexpr double restShare = 0.5;     ///< r, share of Ra that spark-out does not remove
constexpr double deflectionTimes = 2; ///< ratio of τ to the time constant of the deflection

/// h before each step in the steady state, for steps of a in this many passes.
double steadyPress(const LaneBalance& balance, int passes, double a) {
    constexpr int mostSteps = 10'000;
    constexpr double settled = 1e-9;
    double h = a;
    for (int step = 0; step < mostSteps; ++step) {
        double left = h;
        for (int pass = 0; pass < passes; ++pass) {
            const double root = balance.root(left);
            left -= root * root;
        }
        const double next = left + a;
        if (std::abs(next - h) <= settled * h) {
            return next;
        }
        h = next;
    }
    return h;
}

/// Infeed and spark-out at the end of the project's cycle: the last stage with infeed, and the
/// stages after it.
struct CycleEnd {
    std::size_t stage = 0;
    double infeed_mm = 0; ///< 0: no stage has infeed
    double sparkOut = 0;  ///< revolutions or double strokes, if counted
};

CycleEnd endOf(const Project& project) {
    const std::vector<Stage>& stages = project.cycle->stages;
    const std::vector<double> fed_mm = fedByStep_mm(project);
    CycleEnd end;
    for (std::size_t z = stages.size(); z-- > 0;) {
        if (stages[z].feeds() && fed_mm[z] > 0) {
            end.stage = z;
            end.infeed_mm = fed_mm[z];
            break;
        }
        end.sparkOut += stages[z].sparkOutSteps().value_or(0);
    }
    return end;
}

/// Ra [mm] with a factor of 1, at the infeed and the spark-out of a measured one, or else of the
/// cycle.
std::optional<double> steadyRoughness(const Project& project, const MeasuredRa& measured) {
    if (hasErrors(validate(project))) {
        return std::nullopt;
    }
    const CycleEnd end = endOf(project);
    const double a = measured.infeed_um ? *measured.infeed_um / units::umPerMm : end.infeed_mm;
    if (!(a > 0)) {
        return std::nullopt;
    }
    const bool travels = project.operation->travels;
    const Place place{.zone = travels ? Zone::nz : Zone::section,
                      .stage = static_cast<int>(end.stage) + 1};
    const double b = effectiveWidth(project, place);
    const ForceLaw law = forceLaw(project);
    const CompliantPoint gauged =
        compliantPoints(project)[static_cast<std::size_t>(gaugeSection(project))];
    const LaneBalance balance(std::max(gauged.gamma_mm_n, 0.0), b * law.ks, b * law.kr,
                              law.threshold);
    const LastCut cut{.depth_mm = a,
                      .overlap = strokeOverlap(project, b),
                      .pressed_mm = steadyPress(balance, travels ? 2 : 1, a),
                      .step_s = 1, // both times in steps
                      .sparkOut_s = measured.spark_out_steps.value_or(end.sparkOut),
                      .at = place};
    const double computed_mm = RoughnessModel(project, 1).roughness(cut);
    return computed_mm > 0 ? std::optional(computed_mm) : std::nullopt;
}

} // namespace

std::optional<double> computedAsMeasured(const Project& project) {
    const std::optional<MeasuredRa>& measured = project.wheel->measured_ra;
    return measured ? steadyRoughness(project, *measured) : std::nullopt;
}

std::optional<double> usualRoughness(const Project& project) {
    const std::optional<double> computed_mm = steadyRoughness(project, {});
    const RoughnessFactor factor = roughnessFactor(project);
    return computed_mm ? std::optional(*computed_mm * std::sqrt(factor.least * factor.most))
                       : std::nullopt;
}

std::optional<double> factorOfMeasuredRa(const Project& project) {
    const std::optional<double> computed_mm = computedAsMeasured(project);
    if (!computed_mm) {
        return std::nullopt;
    }
    const double factor = project.wheel->measured_ra->ra_um / units::umPerMm / *computed_mm;
    return factor > 0 && factor <= mostRoughnessFactor ? std::optional(factor) : std::nullopt;
}

Project withMeasuredRa(Project project) {
    if (project.wheel->roughness_factor == 1) {
        if (const std::optional<double> factor = factorOfMeasuredRa(project)) {
            project.wheel->roughness_factor = *factor;
        }
    }
    return project;
}

RoughnessFactor roughnessFactor(const Project& project) {
    const double given = project.wheel->roughness_factor;
    if (given == 1) {
        if (const std::optional<double> factor = factorOfMeasuredRa(project)) {
            return {*factor, *factor};
        }
    }
    return isRoughnessCalibrated(project)
               ? RoughnessFactor{given, given}
               : RoughnessFactor{usualRaFactor / roughnessSpread, usualRaFactor * roughnessSpread};
}

RoughnessModel::RoughnessModel(const Project& project)
    : RoughnessModel(project, roughnessFactor(project).least) {}

RoughnessModel::RoughnessModel(const Project& project, double factor)
    : m_cutting(cuttingOf(project))
    , m_grain(project.wheel->grain_mm)
    , m_grainShare(project.wheel->grain_share)
    , m_tipAngle_deg(project.wheel->grain_tip_angle_deg)
    , m_chipping(project.wheel->dressing_chipping_mm)
    , m_factor(factor)
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

double RoughnessModel::roughness(const LastCut& cut, FormulaSheet* sheet) const {
    const bool isStroke = cut.overlap > 1;
    const double a = cut.depth_mm / cut.overlap;
    if (isStroke) {
        state(sheet, "{a} = {a_s}/{u}", {"a", a, "mm"},
              {{"a_s", cut.depth_mm, "mm"}, {"u", cut.overlap, ""}});
    }
    const double straight = roughness(a, sheet);
    if (!(cut.sparkOut_s > 0)) {
        return straight;
    }
    const double tau = deflectionTimes * cut.step_s * cut.pressed_mm / cut.depth_mm;
    const double left = restShare + (1 - restShare) * std::exp(-cut.sparkOut_s / tau);
    const double Ra = straight * left;
    if (sheet) {
        state(sheet, isStroke ? "{τ} = {k}·{T}·{h}/{a_s}" : "{τ} = {k}·{T}·{h}/{a}",
              {"τ", tau, "s"},
              {constantTerm("k", deflectionTimes),
               {"T", cut.step_s, "s"},
               {"h", cut.pressed_mm, "mm"},
               {isStroke ? "a_s" : "a", cut.depth_mm, "mm"}});
        state(sheet, "{Ra_e} = {Ra}·({r} + (1 − {r})·exp(−{t}/{τ}))", {"Ra_e", Ra, "mm"},
              {{"Ra", straight, "mm"},
               constantTerm("r", restShare),
               {"t", cut.sparkOut_s, "s"},
               {"τ", tau, "s"}});
    }
    return Ra;
}

double RoughnessModel::mostDepth(double Ra) const {
    return limitDepth(Ra / restShare);
}

double RoughnessModel::limitDepth(double Ra, double overlap, FormulaSheet* sheet) const {
    const double De = m_cutting.De_mm, eta = m_cutting.dullness;
    const double rows = Ra / (m_factor * isakov);
    const double y = rows * std::sqrt(rows) / m_profile;
    const double s = y * (y + 2 * std::sqrt(eta));
    const double rootShare = s * m_cutting.Vk_mm_s / (std::numbers::pi * m_cutting.Vd_mm_s);
    const double a = overlap * De * rootShare * rootShare;
    if (sheet) {
        stateGrain(sheet);
        state(sheet, "{y} = ({Ra}/({f}·{c}))^(3/2)/{G}", {"y", y, ""},
              {{"Ra", Ra, "mm"},
               {"f", m_factor, ""},
               constantTerm("c", isakov),
               {"G", m_profile, "mm^1.5"}});
        state(sheet, "{s} = {y}·({y} + 2·√({η}))", {"s", s, ""}, {{"y", y, ""}, {"η", eta, ""}});
        const FormulaTerm ofPlace{"D_e", De, "mm"}, share{"s", s, ""},
            ofWheel{"V_k", m_cutting.Vk_mm_s, "mm/s"}, ofWork{"V_d", m_cutting.Vd_mm_s, "mm/s"};
        if (overlap > 1) {
            state(sheet, "{a} = {u}·{D_e}·({s}·{V_k}/(π·{V_d}))²", {"a", a, "mm"},
                  {{"u", overlap, ""}, ofPlace, share, ofWheel, ofWork});
        } else {
            state(sheet, "{a} = {D_e}·({s}·{V_k}/(π·{V_d}))²", {"a", a, "mm"},
                  {ofPlace, share, ofWheel, ofWork});
        }
        state(sheet, "{S_ф} = {a}·{n}", {"S_ф", a * m_cutting.n_rpm, "mm/min"},
              {{"a", a, "mm"}, {"n", m_cutting.n_rpm, "rev/min"}});
    }
    return a;
}

double strokeOverlap(const Project& project, double b) {
    return project.operation->travels ? std::max(1.0, project.wheel->width_mm / b) : 1;
}

bool isRoughnessCalibrated(const Project& project) {
    const auto isOfRoughness = [](const Calibration& calibration) {
        return calibration.input == "/wheel/roughness_factor";
    };
    return project.wheel->roughness_factor != 1 || project.wheel->measured_ra
           || (project.measured
               && std::ranges::any_of(project.measured->calibrations, isOfRoughness));
}

FormulaSheet roughnessSheet(const Project& project, double a) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Roughness"), "MODEL-8", {}};
    stateContact(&sheet, project, cuttingOf(project));
    RoughnessModel(project).roughness(a, &sheet);
    return sheet;
}

FormulaSheet roughnessSheet(const Project& project, const LastCut& cut) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Roughness"), "MODEL-8", {}};
    stateContact(&sheet, project, cuttingOf(project));
    RoughnessModel(project).roughness(cut, &sheet);
    return sheet;
}

FormulaSheet roughnessLimitSheet(const Project& project, double Ra, double b) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Limiting feed, roughness"), "MODEL-8", {}};
    stateContact(&sheet, project, cuttingOf(project));
    RoughnessModel(project).limitDepth(Ra, strokeOverlap(project, b), &sheet);
    return sheet;
}

} // namespace sparkout
