// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/cycle_constraints.h"

#include "core/limits/burn.h"
#include "core/quality/power.h"
#include "core/quality/ranges.h"
#include "core/quality/self_sharpening.h"
#include "core/units.h"

#include <cmath>

namespace sparkout {

namespace {

/// A requirement that holds up to its limit.
ConstraintResult atMost(ConstraintKind kind, double limit, double value,
                        std::optional<Place> at = std::nullopt) {
    ConstraintResult result{kind};
    result.section = -1;
    result.limit = limit;
    result.value = value;
    result.margin = limit - value;
    result.relativeMargin = limit > 0 ? result.margin / limit : result.margin;
    result.holds = result.margin >= 0;
    if (at && at->cycleCount > 0) { // 0: nothing was cut
        result.at = at;
        result.zone = at->zone;
    }
    return result;
}

Peak largestDepth(const SimulationResult& result) {
    Peak largest;
    for (const StageSums& sums : result.sumsByStage) {
        largest = sums.depth_mm.value > largest.value ? sums.depth_mm : largest;
    }
    return largest;
}

// P_y/(b·L) = load(a)·0.25·f_cr·n_g rises with a at every width, so the largest a is the worst.
void addSelfSharpening(const SimulationResult& result, std::vector<ConstraintResult>& found) {
    if (const auto model = selfSharpening(result.project)) {
        const Peak depth = largestDepth(result);
        const double allowed = model->allowedPressure_mpa;
        const double pressure = depth.value > 0 ? model->load(depth.value) * allowed : 0;
        found.push_back(atMost(ConstraintKind::selfSharpening, allowed, pressure, depth.at));
    }
}

// The drives' powers are P_z·V_k and P_z·V_d: the same pass is the worst for both.
void addPowers(const SimulationResult& result, std::vector<ConstraintResult>& found) {
    constexpr double wattsPerKilowatt = 1e3;
    const Machine& machine = result.project.machine;
    const double wheel_kw = result.peakPower_w / wattsPerKilowatt;
    if (machine.wheel_drive_kw) {
        found.push_back(atMost(ConstraintKind::wheelPower, *machine.wheel_drive_kw, wheel_kw,
                               result.peakPowerAt));
    }
    if (machine.work_drive_kw) {
        const Cutting cutting = cuttingOf(result.project);
        found.push_back(atMost(ConstraintKind::workPower, *machine.work_drive_kw,
                               wheel_kw * cutting.Vd_mm_s / cutting.Vk_mm_s, result.peakPowerAt));
    }
}

ConstraintKind kindOf(RangeKind kind) {
    switch (kind) {
    case RangeKind::radialFeed: return ConstraintKind::rangeRadialFeed;
    case RangeKind::axialFeed: return ConstraintKind::rangeAxialFeed;
    case RangeKind::plungeFeed: return ConstraintKind::rangePlungeFeed;
    case RangeKind::workSpeed: break;
    }
    return ConstraintKind::rangeWorkSpeed;
}

void addSettings(const Project& project, std::vector<ConstraintResult>& found) {
    for (const MachineRange& check : checkMachineRanges(project)) {
        ConstraintResult result{kindOf(check.kind)};
        result.section = -1;
        result.stage = check.stage;
        result.value = check.value;
        result.isLeast = check.value - check.low < check.high - check.value;
        result.limit = result.isLeast ? check.low : check.high;
        result.otherEnd = result.isLeast ? check.high : check.low;
        result.margin = check.margin;
        result.relativeMargin = check.relativeMargin;
        result.holds = check.holds;
        found.push_back(result);
    }
    if (const auto gauge = checkGaugeCommands(project)) {
        found.push_back(atMost(ConstraintKind::gaugeCommands, gauge->commands, gauge->stages));
    }
    for (const OverlapCheck& check : checkOverlaps(project)) {
        ConstraintResult result{ConstraintKind::overlap};
        result.section = -1;
        result.stage = check.stage;
        result.value = check.overlap;
        result.limit = leastOverlap;
        result.isLeast = true;
        result.margin = check.overlap - leastOverlap;
        result.relativeMargin = result.margin / leastOverlap;
        result.holds = check.holds();
        found.push_back(result);
    }
}

} // namespace

std::optional<BurnState> burnStateOf(const SimulationResult& result) {
    const auto& U = result.project.material.burn_rise_k;
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

std::vector<ConstraintResult> cycleConstraints(const SimulationResult& result) {
    std::vector<ConstraintResult> found;
    if (const auto burn = burnStateOf(result)) {
        found.push_back(atMost(ConstraintKind::burn, burn->limitDepth_mm * units::umPerMm,
                               burn->visit.depth_mm * units::umPerMm, burn->visit.at));
    }
    addSelfSharpening(result, found);
    addPowers(result, found);
    addSettings(result.project, found);
    return found;
}

} // namespace sparkout
