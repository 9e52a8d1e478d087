// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/recipe_force.h"

#include "core/project/wheel.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace sparkout {

namespace {

double sineOf(double angle_deg) {
    constexpr double halfTurn_deg = 180;
    return std::sin(angle_deg * std::numbers::pi / halfTurn_deg);
}

bool hasWearFlats(const Wheel& wheel) {
    return wheel.force_recipe && wheel.force_recipe->wear_flat_mm;
}

} // namespace

RecipeShares recipeShares(const Wheel& wheel, const ForceRecipe& recipe) {
    const double Wg = wheel.grain_share, Wb = wheel.bond_share, dg = wheel.grain_mm;
    RecipeShares shares;
    shares.cuttingGrains_mm2 = recipe.contact_factor * Wg * Wb / ((1 - Wg - Wb) * dg * dg);
    const double balanced = // b_j·n_c of κ = 1
        recipe.grains_per_mm * sineOf(recipe.shear_angle_deg) / 2;
    shares.cutWidth_mm = recipe.cut_width_mm.value_or(balanced / shares.cuttingGrains_mm2);
    const double perMm = shares.cutWidth_mm * shares.cuttingGrains_mm2;
    shares.shear = recipe.cut_width_mm ? perMm / balanced : 1;
    shares.dullness = recipe.wear_flat_mm ? *recipe.wear_flat_mm * perMm : wheel.dullness;
    return shares;
}

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

} // namespace sparkout
