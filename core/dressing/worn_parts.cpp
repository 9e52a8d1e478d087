// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/worn_parts.h"

#include "core/process/recipe_force.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <numbers>

namespace sparkout {

double nominalVolume_mm3(const Project& project) {
    const Part& part = *project.part;
    return std::numbers::pi * part.diameter_mm * part.stock_mm * part.length_mm
           * engagedShare(part);
}

WornParts::WornParts(const Setup& setup, const SetupRun& first)
    : m_dressed(*setup.surfaces.front().project.wheel), m_wear(setup.wear) {
    double before_mm3 = 0;
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        m_before_mm3.push_back(before_mm3);
        before_mm3 += i < first.surfaces.size() ? first.surfaces[i].removed_mm3 : 0;
        m_part_mm3 += nominalVolume_mm3(setup.surfaces[i].project);
    }
}

Wheel WornParts::wheel(std::size_t surface, std::int64_t part) const {
    const double parts = static_cast<double>(part - 1);
    return wheelAfter(m_dressed, m_wear, parts * m_part_mm3 + m_before_mm3[surface]);
}

bool WornParts::isWornOut(std::int64_t part) const {
    const bool asDullAsCanBe = !m_wear.dulling_per_mm2 || dullnessOf(wheel(0, part)) >= 1;
    return asDullAsCanBe && !m_wear.grinding_ratio;
}

} // namespace sparkout
