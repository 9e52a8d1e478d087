// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/recipe_force.h"

#include "core/project/wheel.h"

#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

double sineOf(double angle_deg) {
    constexpr double halfTurn_deg = 180;
    return std::sin(angle_deg * std::numbers::pi / halfTurn_deg);
}

} // namespace

RecipeShares recipeShares(const Project& project, const ForceRecipe& recipe) {
    const Wheel& wheel = *project.wheel;
    const double Wg = wheel.grain_share, Wb = wheel.bond_share, dg = wheel.grain_mm;
    RecipeShares shares;
    shares.cuttingGrains_mm2 = recipe.contactFactor * Wg * Wb / ((1 - Wg - Wb) * dg * dg);
    const double perMm2 = recipe.cutWidth_mm * shares.cuttingGrains_mm2;
    shares.shear = 2 * perMm2 / (recipe.grainsPerMm * sineOf(recipe.shearAngle_deg));
    shares.dullness = recipe.flatLength_mm * perMm2;
    return shares;
}

ForceLaw forceLawOf(const Project& project, const ForceRecipe& recipe) {
    const RecipeShares shares = recipeShares(project, recipe);
    Project plain = project;
    plain.wheel->dullness = shares.dullness;
    ForceLaw law = forceLaw(plain);
    law.ks *= shares.shear;
    law.kt *= shares.shear;
    return law;
}

double balancedCutWidth(const Project& project, const ForceRecipe& recipe) {
    return recipe.cutWidth_mm / recipeShares(project, recipe).shear;
}

} // namespace sparkout
