// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/depth_limits.h"

#include "core/limits/burn.h"
#include "core/process/system_compliance.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/quality/self_sharpening.h"
#include "core/units.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr double milliwattsPerKilowatt = 1e6;

} // namespace

std::vector<DepthLimit> depthLimits(const Project& project, double b, double stock) {
    std::vector<DepthLimit> limits;
    if (const auto& Ra = project.part.tolerance.roughness_ra_um) {
        limits.push_back(
            {ConstraintKind::roughness, RoughnessModel(project).limitDepth(*Ra / units::umPerMm)});
    }
    if (const auto& U = project.material.burn_rise_k) {
        limits.push_back({ConstraintKind::burn, BurnModel(project).limitDepth(*U, stock)});
    }
    if (const auto sharpening = selfSharpening(project)) {
        limits.push_back({ConstraintKind::selfSharpening, sharpening->limitDepth().value_or(0)});
    }
    const PowerModel power(project);
    if (const auto& N = project.machine.wheel_drive_kw) {
        limits.push_back(
            {ConstraintKind::wheelPower, power.wheelLimitDepth(b, *N * milliwattsPerKilowatt)});
    }
    if (const auto& N = project.machine.work_drive_kw) {
        limits.push_back(
            {ConstraintKind::workPower, power.workLimitDepth(b, *N * milliwattsPerKilowatt)});
    }
    return limits;
}

bool wheelStands(const Place& place) {
    switch (place.zone) {
    case Zone::rz1:
        return place.step == Step::e1 || place.step == Step::e2 || place.step == Step::e5;
    case Zone::rz2: return place.step == Step::e2;
    case Zone::nz:
    case Zone::section: break;
    }
    return false;
}

double effectiveWidth(const Project& project, const Place& place) {
    const StageFeed* const axial = project.operation->axial();
    if (!axial) {
        return project.part.length_mm;
    }
    if (wheelStands(place)) {
        const ZoneLengths lengths = zoneLengths(project);
        return place.zone == Zone::rz1 ? lengths.rz1 : lengths.rz2;
    }
    const Stage& stage = project.cycle.stages[static_cast<std::size_t>(place.stage - 1)];
    return std::min((stage.*axial->value).value_or(0) / project.machine.work_speed_rpm,
                    project.wheel.width_mm);
}

} // namespace sparkout
