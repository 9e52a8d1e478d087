// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/force.h"

#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"

#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

bool hasWearFlats(const Wheel& wheel) {
    return wheel.force_recipe && wheel.force_recipe->wear_flat_mm;
}

} // namespace

double dullnessOf(const Wheel& wheel) {
    return hasWearFlats(wheel) ? recipeShares(wheel, *wheel.force_recipe).dullness : wheel.dullness;
}

void setDullness(Wheel& wheel, double dullness) {
    if (!hasWearFlats(wheel)) {
        wheel.dullness = dullness;
        return;
    }
    const RecipeShares shares = recipeShares(wheel, *wheel.force_recipe);
    wheel.force_recipe->wear_flat_mm = dullness / (shares.cutWidth_mm * shares.cuttingGrains_mm2);
}

const char* dullnessPath(const Wheel& wheel) {
    return hasWearFlats(wheel) ? "/wheel/force_recipe/wear_flat_mm" : "/wheel/dullness";
}

double equivalentDiameter(double d, double D, Surface surface) {
    return d * D / (surface == Surface::external ? D + d : d - D);
}

bool hasThreshold(const Project& project) {
    return project.material->force_law == ForceLawKind::threshold;
}

ForceLaw forceLaw(const Project& project) {
    const Material& material = *project.material;
    const double d = project.part->diameter_mm;
    const double De = equivalentDiameter(d, project.wheel->diameter_mm, project.part->surface);
    const double Vd = std::numbers::pi * d * project.machine->work_speed_rpm; // mm/min
    const double Vk =
        project.machine->wheel_speed_m_s * units::mmPerM * units::secondsPerMinute; // mm/min
    if (hasThreshold(project)) {
        const double K0 = material.specific_force_mpa;
        const double Kz0 = material.specific_tangential_force_mpa.value_or(
            K0 * material.shear_strain / material.shear_factor);
        return {.ks = K0 * Vd / Vk,
                .kr = material.threshold_force_n_mm,
                .kt = Kz0 * Vd / Vk,
                .mu = material.friction,
                .threshold = true};
    }
    const double sigma = material.flow_stress_mpa;
    ForceLaw law{.ks = material.shear_factor * sigma * Vd / Vk,
                 .kr = dullnessOf(*project.wheel) * sigma * std::sqrt(De) / 3,
                 .kt = material.shear_strain * sigma * Vd / Vk,
                 .mu = material.friction};
    if (project.wheel->force_recipe) {
        const double shear = recipeShares(*project.wheel, *project.wheel->force_recipe).shear;
        law.ks *= shear;
        law.kt *= shear;
    }
    return law;
}

} // namespace sparkout
