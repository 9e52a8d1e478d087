// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/pass_cuts.h"

#include "core/limits/cutting.h"
#include "core/process/coupled_sections.h"
#include "core/quality/self_sharpening.h"
#include "core/units.h"

namespace sparkout {

namespace {
constexpr double peakRounding = 1e-9;
} // namespace

// With sections coupled peak power is an integral over the length, which the passes do not keep.
PassCuts::PassCuts(const Project& project)
    : m_points(static_cast<std::size_t>(placeCount(project)))
    , m_least_mm(project.part.lower_deviation_um / units::umPerMm - 2 * diameterSlack_mm)
    , m_most_mm(project.part.upper_deviation_um / units::umPerMm + 2 * diameterSlack_mm)
    , m_isBore(project.part.surface == Surface::internal) {
    const Machine& machine = project.machine;
    if (machine.wheel_drive_kw && !isCoupled(project)) {
        m_wheelPower_w = *machine.wheel_drive_kw * units::wPerKw * (1 + peakRounding);
    }
    if (machine.work_drive_kw && !isCoupled(project)) {
        const Cutting cutting = cuttingOf(project);
        m_workPower_w = *machine.work_drive_kw * units::wPerKw * cutting.Vk_mm_s / cutting.Vd_mm_s
                        * (1 + peakRounding);
    }
    if (const auto model = selfSharpening(project)) {
        if (const auto depth = model->limitDepth()) {
            m_depth_mm = *depth * (1 + peakRounding);
        }
    }
}

std::optional<ConstraintKind> PassCuts::broken(const Run& run, std::size_t stage) const {
    const StageSums& sums = run.sumsOf(stage);
    if (run.surelyBurned()) {
        return ConstraintKind::burn;
    }
    if (m_depth_mm && sums.depth_mm.value > *m_depth_mm) {
        return ConstraintKind::selfSharpening;
    }
    if (m_wheelPower_w && sums.power_w.value > *m_wheelPower_w) {
        return ConstraintKind::wheelPower;
    }
    if (m_workPower_w && sums.power_w.value > *m_workPower_w) {
        return ConstraintKind::workPower;
    }
    return std::nullopt;
}

std::optional<ConstraintKind> PassCuts::brokenAtEnd(const Run& run) const {
    for (std::size_t point = 0; point < m_points; ++point) {
        const auto [least, most] = run.diameterDeviations(point);
        if (least < m_least_mm) {
            return ConstraintKind::diameterMin;
        }
        if (most > m_most_mm) {
            return ConstraintKind::diameterMax;
        }
    }
    return std::nullopt;
}

} // namespace sparkout
