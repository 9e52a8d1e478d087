// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/surface_wear.h"

#include "core/process/recipe_force.h"
#include "core/project/part.h"

#include <numbers>

namespace sparkout {

double nominalVolume_mm3(const Project& project) {
    const Part& part = *project.part;
    return std::numbers::pi * part.diameter_mm * part.stock_mm * part.length_mm
           * engagedShare(part);
}

Wheel SurfaceWear::wheel(std::int64_t part) const {
    return wheelAfter(dressed, wear, static_cast<double>(part - 1) * part_mm3 + before_mm3);
}

bool SurfaceWear::isWornOut(std::int64_t part) const {
    const bool asDullAsCanBe = !wear.dulling_per_mm2 || dullnessOf(wheel(part)) >= 1;
    return asDullAsCanBe && !wear.grinding_ratio;
}

SurfaceWear surfaceWear(const Setup& setup, std::size_t surface, double before_mm3) {
    SurfaceWear made{*setup.surfaces[surface].project.wheel, setup.wear, 0, before_mm3};
    for (const GroundSurface& each : setup.surfaces) {
        made.part_mm3 += nominalVolume_mm3(each.project);
    }
    return made;
}

} // namespace sparkout
