// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/recipe_force.h"

#include "core/project/wheel.h"

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

} // namespace sparkout
