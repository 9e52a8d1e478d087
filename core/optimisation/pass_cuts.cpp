// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/pass_cuts.h"

#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>

namespace sparkout {

namespace {
constexpr double peakRounding = 1e-9;
} // namespace

PassCuts::PassCuts(const Project& project)
    : m_points(static_cast<std::size_t>(zoneSectionCount(project) > 0 ? zoneSectionCount(project)
                                                                      : placeCount(project)))
    , m_low_mm(project.part->lower_deviation_um / units::umPerMm)
    , m_high_mm(project.part->upper_deviation_um / units::umPerMm)
    , m_least_mm(m_low_mm - 2 * diameterSlack_mm)
    , m_most_mm(m_high_mm + 2 * diameterSlack_mm)
    , m_isBore(project.part->surface == Surface::internal) {
    for (const Requirement& row : requirementRows) {
        if (auto bound = row.passBound ? row.passBound(project) : std::nullopt) {
            bound->most *= 1 + peakRounding;
            m_bounds.emplace_back(row.kind, *bound);
            m_most.push_back(bound->most);
        }
    }
}

// Self-sharpening does not limit the depth of cut itself, so its share is unknown here.
void PassCuts::demandMargin(double least) {
    constexpr double lastBits = 1e-9;
    const double demanded = std::max(least - lastBits, 0.0);
    const double edge_mm = demanded * (m_high_mm - m_low_mm);
    m_least_mm = m_low_mm + edge_mm - 2 * diameterSlack_mm;
    m_most_mm = m_high_mm - edge_mm + 2 * diameterSlack_mm;
    for (std::size_t i = 0; i < m_bounds.size(); ++i) {
        const PassBound& bound = m_bounds[i].second;
        m_most[i] = bound.most * (bound.peak == PassBound::Peak::power_w ? 1 - demanded : 1);
    }
}

std::optional<ConstraintKind> PassCuts::broken(const Run& run, std::size_t stage) const {
    if (run.surelyBurned()) {
        return ConstraintKind::burn;
    }
    const StageSums& sums = run.sumsOf(stage);
    for (std::size_t i = 0; i < m_bounds.size(); ++i) {
        const auto& [kind, bound] = m_bounds[i];
        const bool depth = bound.peak == PassBound::Peak::depth_mm;
        if ((depth ? sums.depth_mm : sums.power_w).value > m_most[i]) {
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
