// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/cycle_constraints.h"

#include "core/process/coupled_sections.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/quality/limit_series.h"
#include "core/quality/power.h"
#include "core/quality/ranges.h"
#include "core/surface/burn.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double wattsPerKilowatt = 1e3;
constexpr double milliwattsPerWatt = 1e3;
constexpr double milliwattsPerKilowatt = 1e6;

/// Adds an upper limit with its worst place.
void add(ConstraintKind kind, double limit, double value, const Place& at,
         ConstraintResults& found) {
    ConstraintResult result = held(kind, Side::atMost, limit, value, limit);
    if (at.cycleCount > 0) { // 0: no cut was made
        result.at = at;
        result.zone = at.zone;
    }
    found.push_back(result);
}

Peak largestDepth(const SimulationResult& result) {
    Peak largest;
    for (const StageSums& sums : result.sumsByStage) {
        largest = sums.depth_mm.value > largest.value ? sums.depth_mm : largest;
    }
    return largest;
}

/// The width and the depth of cut with the largest P_z·V_k.
struct PeakCut {
    double b = 0, a = 0;
};
std::optional<PeakCut> peakCut(const SimulationResult& result) {
    const Project& project = result.project;
    if (isCoupled(project) || result.peakPower_w <= 0) {
        return std::nullopt;
    }
    const double b = effectiveWidth(project, result.peakPowerAt);
    const double a = PowerModel(project).wheelLimitDepth(b, result.peakPower_w * milliwattsPerWatt);
    return a > 0 ? std::optional(PeakCut{b, a}) : std::nullopt; // otherwise the wheel only rubbed
}

} // namespace

std::optional<BurnState> burnStateOf(const SimulationResult& result) {
    const auto& U = result.project.material->burn_rise_k;
    if (!U) {
        return std::nullopt;
    }
    const BurnModel model(result.project);
    BurnState state;
    state.visit = result.burn.value_or(BurnVisit{});
    const double a = state.visit.depth_mm;
    state.limitDepth_mm = model.limitDepth(*U, state.visit.stock_mm);
    state.rise_k = model.rise(state.visit.stock_mm, a);
    state.damagedDepth_mm = model.damagedDepth(a, *U);
    return state;
}

void evaluateBurn(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto burn = burnStateOf(of.result)) {
        add(kind, burn->limitDepth_mm * units::umPerMm, burn->visit.depth_mm * units::umPerMm,
            burn->visit.at, found);
    }
}

std::optional<FormulaSheet> sheetOfBurn(const Judged& of) {
    const std::optional<BurnVisit>& burn = of.result.burn;
    const Project& project = of.result.project;
    return burn ? std::optional(
               burnLimitSheet(project, *project.material->burn_rise_k, burn->stock_mm))
                : std::nullopt;
}

std::optional<double> burnDepth(const Project& project, double /*b*/, double stock) {
    const auto& U = project.material->burn_rise_k;
    return U ? std::optional(BurnModel(project).limitDepth(*U, stock)) : std::nullopt;
}

// P_y/(b·L) = load(a)·0.25·f_cr·n_g rises with a at every width, so the largest a is the worst.
void evaluateSelfSharpening(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto model = selfSharpening(of.result.project)) {
        const Peak depth = largestDepth(of.result);
        const double allowed = model->allowedPressure_mpa;
        const double pressure = depth.value > 0 ? model->load(depth.value) * allowed : 0;
        add(kind, allowed, pressure, depth.at, found);
    }
}

std::optional<FormulaSheet> sheetOfSelfSharpening(const Judged& of) {
    return selfSharpeningSheet(of.result.project);
}

std::optional<double> selfSharpeningDepth(const Project& project, double /*b*/, double /*stock*/) {
    const auto model = selfSharpening(project);
    return model ? std::optional(model->limitDepth().value_or(0)) : std::nullopt;
}

std::optional<PassBound> selfSharpeningBound(const Project& project) {
    const auto model = selfSharpening(project);
    const auto depth = model ? model->limitDepth() : std::nullopt;
    return depth ? std::optional(PassBound{PassBound::Peak::depth_mm, *depth}) : std::nullopt;
}

// The drives' powers are P_z·V_k and P_z·V_d: the same pass is the worst for both.
void evaluateWheelPower(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto& limit = of.result.project.machine->wheel_drive_kw) {
        add(kind, *limit, of.result.peakPower_w / wattsPerKilowatt, of.result.peakPowerAt, found);
    }
}

std::optional<FormulaSheet> sheetOfWheelPower(const Judged& of) {
    const auto cut = peakCut(of.result);
    return cut ? std::optional(wheelPowerSheet(of.result.project, cut->b, cut->a)) : std::nullopt;
}

std::optional<double> wheelPowerDepth(const Project& project, double b, double /*stock*/) {
    const auto& N = project.machine->wheel_drive_kw;
    return N ? std::optional(PowerModel(project).wheelLimitDepth(b, *N * milliwattsPerKilowatt))
             : std::nullopt;
}

std::optional<PassBound> wheelPowerBound(const Project& project) {
    const auto& limit = project.machine->wheel_drive_kw;
    return limit && !isCoupled(project)
               ? std::optional(PassBound{PassBound::Peak::power_w, *limit * wattsPerKilowatt})
               : std::nullopt;
}

void evaluateWorkPower(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto& limit = of.result.project.machine->work_drive_kw) {
        const Cutting cutting = cuttingOf(of.result.project);
        add(kind, *limit,
            of.result.peakPower_w / wattsPerKilowatt * cutting.Vd_mm_s / cutting.Vk_mm_s,
            of.result.peakPowerAt, found);
    }
}

std::optional<FormulaSheet> sheetOfWorkPower(const Judged& of) {
    const auto cut = peakCut(of.result);
    return cut ? std::optional(workPowerSheet(of.result.project, cut->b, cut->a)) : std::nullopt;
}

std::optional<double> workPowerDepth(const Project& project, double b, double /*stock*/) {
    const auto& N = project.machine->work_drive_kw;
    return N ? std::optional(PowerModel(project).workLimitDepth(b, *N * milliwattsPerKilowatt))
             : std::nullopt;
}

std::optional<PassBound> workPowerBound(const Project& project) {
    const auto& limit = project.machine->work_drive_kw;
    if (!limit || isCoupled(project)) {
        return std::nullopt;
    }
    const Cutting cutting = cuttingOf(project);
    return PassBound{PassBound::Peak::power_w,
                     *limit * wattsPerKilowatt * cutting.Vk_mm_s / cutting.Vd_mm_s};
}

void evaluateRange(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    for (const MachineRange& range : checkMachineRanges(of.result.project, kind)) {
        const bool low = range.value - range.low < range.high - range.value;
        const double width = range.high - range.low;
        found.push_back(held(kind, low ? Side::atLeast : Side::atMost, low ? range.low : range.high,
                             range.value, width > 0 ? width : std::max(std::abs(range.high), 1.0)));
        found.back().stage = range.stage;
        found.back().otherEnd = low ? range.high : range.low;
    }
}

void evaluateGaugeCommands(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto gauge = checkGaugeCommands(of.result.project)) {
        found.push_back(held(kind, Side::atMost, gauge->commands, gauge->stages, gauge->commands));
    }
}

void evaluateOverlap(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    for (const OverlapCheck& check : checkOverlaps(of.result.project)) {
        if (check.kind == kind) {
            found.push_back(held(kind, Side::atLeast, check.least, check.overlap, check.least));
            found.back().stage = check.stage;
            found.back().holds = check.holds();
        }
    }
}

void evaluateLeastSteps(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const std::optional<int>& least = of.result.project.least_steps;
    const std::optional<StageSteps> fewest = least ? fewestSteps(of.result) : std::nullopt;
    if (fewest) {
        found.push_back(held(kind, Side::atLeast, *least, fewest->steps, *least));
        found.back().stage = fewest->stage;
    }
}

} // namespace sparkout
