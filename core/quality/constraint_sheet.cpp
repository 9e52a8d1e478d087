// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/constraint_sheet.h"
#include "core/quality/drawing_constraints.h"

#include "core/limits/burn.h"
#include "core/process/coupled_sections.h"
#include "core/quality/depth_limits.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/quality/self_sharpening.h"
#include "core/units.h"

#include <algorithm>

namespace sparkout {

namespace {

std::optional<FormulaSheet> formSheet(const SimulationResult& result, const PartAccuracy& accuracy,
                                      const ConstraintResult& constraint) {
    const auto index = static_cast<std::size_t>(std::max(constraint.section, 0));
    const double geometric = result.project.machine.geometric_runout_um / units::umPerMm;
    const std::vector<SectionShape> shapes = shapesOf(result);
    switch (constraint.kind) {
    case ConstraintKind::radialRunout: return radialRunoutSheet(shapes[index], geometric);
    case ConstraintKind::roundness: return roundnessSheet(accuracy.sections[index].minimumZone);
    case ConstraintKind::cylindricity: return cylindricitySheet(accuracy.minimumZone);
    case ConstraintKind::totalRunout: return totalRunoutSheet(shapes, geometric);
    case ConstraintKind::roughness:
        return roughnessSheet(result.project, result.sections[index].lastCut->depth_mm);
    default: return std::nullopt;
    }
}

/// The largest P_z·V_k, from which the depth of cut that took it follows.
std::optional<FormulaSheet> powerSheet(const SimulationResult& result, ConstraintKind kind) {
    const Project& project = result.project;
    if (isCoupled(project) || result.peakPower_w <= 0) {
        return std::nullopt;
    }
    constexpr double milliwattsPerWatt = 1e3;
    const double b = effectiveWidth(project, result.peakPowerAt);
    const double a = PowerModel(project).wheelLimitDepth(b, result.peakPower_w * milliwattsPerWatt);
    return kind == ConstraintKind::wheelPower ? wheelPowerSheet(project, b, a)
                                              : workPowerSheet(project, b, a);
}

} // namespace

std::optional<FormulaSheet> constraintSheet(const SimulationResult& result,
                                            const PartAccuracy& accuracy,
                                            const ConstraintResult& constraint) {
    const Project& project = result.project;
    switch (constraint.kind) {
    case ConstraintKind::burn:
        return result.burn ? std::optional(
                   burnLimitSheet(project, *project.material.burn_rise_k, result.burn->stock_mm))
                           : std::nullopt;
    case ConstraintKind::selfSharpening: return selfSharpeningSheet(project);
    case ConstraintKind::wheelPower:
    case ConstraintKind::workPower: return powerSheet(result, constraint.kind);
    default: return formSheet(result, accuracy, constraint);
    }
}

} // namespace sparkout
