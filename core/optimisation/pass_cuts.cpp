// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/pass_cuts.h"

#include "core/project/part.h"
#include "core/units.h"

namespace sparkout {

namespace {
constexpr double peakRounding = 1e-9;
} // namespace

PassCuts::PassCuts(const Project& project)
    : m_points(static_cast<std::size_t>(zoneSectionCount(project) > 0 ? zoneSectionCount(project)
                                                                      : placeCount(project)))
    , m_least_mm(project.part->lower_deviation_um / units::umPerMm - 2 * diameterSlack_mm)
    , m_most_mm(project.part->upper_deviation_um / units::umPerMm + 2 * diameterSlack_mm)
    , m_isBore(project.part->surface == Surface::internal) {
    for (const Requirement& row : requirementRows) {
        if (auto bound = row.passBound ? row.passBound(project) : std::nullopt) {
            bound->most *= 1 + peakRounding;
            m_bounds.emplace_back(row.kind, *bound);
        }
    }
}

std::optional<ConstraintKind> PassCuts::broken(const Run& run, std::size_t stage) const {
    if (run.surelyBurned()) {
        return ConstraintKind::burn;
    }
    const StageSums& sums = run.sumsOf(stage);
    for (const auto& [kind, bound] : m_bounds) {
        const bool depth = bound.peak == PassBound::Peak::depth_mm;
        if ((depth ? sums.depth_mm : sums.power_w).value > bound.most) {
            return kind;
        }
    }
    return std::nullopt;
}

std::optional<ConstraintKind> PassCuts::brokenAtEnd(const Run& run) const {
    for (std::size_t i = 0; i < m_points; ++i) {
        const auto [least, most] = run.diameterDeviations(run.firstCounted() + i);
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
