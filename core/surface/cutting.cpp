// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/cutting.h"

#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/text.h"
#include "core/units.h"

#include <cmath>
#include <numbers>

namespace sparkout {

Cutting cuttingOf(const Project& project) {
    Cutting cutting;
    cutting.law = forceLaw(project);
    cutting.d_mm = project.part->diameter_mm;
    cutting.D_mm = project.wheel->diameter_mm;
    cutting.De_mm = equivalentDiameter(cutting.d_mm, cutting.D_mm, project.part->surface);
    cutting.n_rpm = project.machine->work_speed_rpm;
    cutting.Vd_mm_s = std::numbers::pi * cutting.d_mm * cutting.n_rpm / units::secondsPerMinute;
    cutting.Vk_mm_s = project.machine->wheel_speed_m_s * units::mmPerM;
    cutting.dullness = dullnessOf(*project.wheel);
    return cutting;
}

namespace {

// The coefficients are computed by forceLaw(); a test compares the formulas shown here with it.

/// Shows the results of the wheel's recipe, if the force follows from it.
void stateRecipe(FormulaSheet* sheet, const Wheel& wheel) {
    if (!sheet || !wheel.force_recipe) {
        return;
    }
    constexpr double halfTurn_deg = 180;
    const ForceRecipe& recipe = *wheel.force_recipe;
    const RecipeShares shares = recipeShares(wheel, recipe);
    state(sheet, "{n_c} = {k_Y}·{W_g}·{W_b}/(({c} − {W_g} − {W_b})·{d_g}²)",
          {"n_c", shares.cuttingGrains_mm2, "1/mm²"},
          {{"k_Y", recipe.contact_factor, ""},
           {"W_g", wheel.grain_share, ""},
           {"W_b", wheel.bond_share, ""},
           {"d_g", wheel.grain_mm, "mm"},
           constantTerm("c", 1)});
    const FormulaTerm perArea{"n_c", shares.cuttingGrains_mm2, "1/mm²"},
        perLength{"m_D", recipe.grains_per_mm, "1/mm"},
        angle{"sin β_1", std::sin(recipe.shear_angle_deg * std::numbers::pi / halfTurn_deg), ""},
        width{"b_j", shares.cutWidth_mm, "mm"};
    if (recipe.cut_width_mm) {
        state(sheet, "{κ} = {c}·{b_j}·{n_c}/({m_D}·{sin β_1})", {"κ", shares.shear, ""},
              {width, perArea, perLength, angle, constantTerm("c", 2)});
    } else {
        state(sheet, "{b_j} = {m_D}·{sin β_1}/({c}·{n_c})", width,
              {perLength, angle, perArea, constantTerm("c", 2)});
    }
    if (recipe.wear_flat_mm) {
        state(sheet, "{η} = {l_g}·{b_j}·{n_c}", {"η", shares.dullness, ""},
              {{"l_g", *recipe.wear_flat_mm, "mm"}, width, perArea});
    }
}

/// Shows k_s or k_t: σ_i·V_d/V_k times a coefficient, and times κ if a recipe gives the cut width.
void stateShear(FormulaSheet* sheet, const Project& project, const Cutting& cutting,
                const FormulaTerm& result, const FormulaTerm& coefficient, const char* plain,
                const char* byRecipe) {
    const FormulaTerm stress{"σ_i", project.material->flow_stress_mpa, "MPa"},
        work{"V_d", cutting.Vd_mm_s, "mm/s"}, wheel{"V_k", cutting.Vk_mm_s, "mm/s"};
    const auto& recipe = project.wheel->force_recipe;
    if (recipe && recipe->cut_width_mm) {
        const double shear = recipeShares(*project.wheel, *recipe).shear;
        state(sheet, byRecipe, result, {{"κ", shear, ""}, coefficient, stress, work, wheel});
    } else {
        state(sheet, plain, result, {coefficient, stress, work, wheel});
    }
}

void stateFriction(FormulaSheet* sheet, const Project& project, const Cutting& cutting) {
    state(sheet, "{k_r} = {η}·{σ_i}·√({D_e})/{c}", {"k_r", cutting.law.kr, "N/mm^1.5"},
          {{"η", cutting.dullness, ""},
           {"σ_i", project.material->flow_stress_mpa, "MPa"},
           {"D_e", cutting.De_mm, "mm"},
           constantTerm("c", 3)});
}

} // namespace

void stateContact(FormulaSheet* sheet, const Project& project, const Cutting& cutting) {
    const bool external = project.part->surface == Surface::external;
    state(sheet, external ? "{D_e} = {d}·{D}/({D} + {d})" : "{D_e} = {d}·{D}/({d} − {D})",
          {"D_e", cutting.De_mm, "mm"}, {{"d", cutting.d_mm, "mm"}, {"D", cutting.D_mm, "mm"}});
    state(sheet, "{V_d} = π·{d}·{n}/{s}", {"V_d", cutting.Vd_mm_s, "mm/s"},
          {{"d", cutting.d_mm, "mm"},
           {"n", cutting.n_rpm, "rev/min"},
           constantTerm("s", units::secondsPerMinute)});
    stateRecipe(sheet, *project.wheel);
}

void stateNormal(FormulaSheet* sheet, const Project& project, const Cutting& cutting) {
    if (cutting.law.threshold) {
        state(sheet, "{K} = {K_0}·{V_d}/{V_k}", {"K", cutting.law.ks, "MPa"},
              {{"K_0", project.material->specific_force_mpa, "MPa"},
               {"V_d", cutting.Vd_mm_s, "mm/s"},
               {"V_k", cutting.Vk_mm_s, "mm/s"}});
        return;
    }
    stateShear(sheet, project, cutting, {"k_s", cutting.law.ks, "MPa"},
               {"ε_i·tg β", project.material->shear_factor, ""},
               "{k_s} = {ε_i·tg β}·{σ_i}·{V_d}/{V_k}", "{k_s} = {κ}·{ε_i·tg β}·{σ_i}·{V_d}/{V_k}");
    stateFriction(sheet, project, cutting);
}

void stateTangential(FormulaSheet* sheet, const Project& project, const Cutting& cutting) {
    if (cutting.law.threshold) {
        const Material& material = *project.material;
        const double own = cutting.law.kt * cutting.Vk_mm_s / cutting.Vd_mm_s;
        if (!material.specific_tangential_force_mpa) {
            state(sheet, "{K_z0} = {K_0}·{ε_i}/{ε_i·tg β}", {"K_z0", own, "MPa"},
                  {{"K_0", material.specific_force_mpa, "MPa"},
                   {"ε_i", material.shear_strain, ""},
                   {"ε_i·tg β", material.shear_factor, ""}});
        }
        state(sheet, "{K_z} = {K_z0}·{V_d}/{V_k}", {"K_z", cutting.law.kt, "MPa"},
              {{"K_z0", own, "MPa"},
               {"V_d", cutting.Vd_mm_s, "mm/s"},
               {"V_k", cutting.Vk_mm_s, "mm/s"}});
        return;
    }
    stateShear(sheet, project, cutting, {"k_t", cutting.law.kt, "MPa"},
               {"ε_i", project.material->shear_strain, ""}, "{k_t} = {ε_i}·{σ_i}·{V_d}/{V_k}",
               "{k_t} = {κ}·{ε_i}·{σ_i}·{V_d}/{V_k}");
    stateFriction(sheet, project, cutting);
}

void stateNormalForce(FormulaSheet* sheet, const ForceLaw& law, double b, double a) {
    const FormulaTerm force{"P_y", law.normal(b, std::sqrt(a)), "N"}, width{"b", b, "mm"},
        depth{"a", a, "mm"};
    if (law.threshold) {
        state(sheet, "{P_y} = {b}·({F′_0} + {K}·{a})", force,
              {width, {"F′_0", law.kr, "N/mm"}, {"K", law.ks, "MPa"}, depth});
    } else {
        state(sheet, "{P_y} = {b}·({k_s}·{a} + {k_r}·√({a}))", force,
              {width, {"k_s", law.ks, "MPa"}, depth, {"k_r", law.kr, "N/mm^1.5"}});
    }
}

void stateTangentialForce(FormulaSheet* sheet, const ForceLaw& law, double b, double a) {
    const FormulaTerm force{"P_z", law.tangential(b, std::sqrt(a)), "N"}, width{"b", b, "mm"},
        depth{"a", a, "mm"}, friction{"μ", law.mu, ""};
    if (law.threshold) {
        state(sheet, "{P_z} = {b}·({K_z}·{a} + {μ}·{F′_0})", force,
              {width, {"K_z", law.kt, "MPa"}, depth, friction, {"F′_0", law.kr, "N/mm"}});
    } else {
        state(sheet, "{P_z} = {b}·({k_t}·{a} + {μ}·{k_r}·√({a}))", force,
              {width, {"k_t", law.kt, "MPa"}, depth, friction, {"k_r", law.kr, "N/mm^1.5"}});
    }
}

FormulaSheet beginTangential(const Project& project, const char* name) {
    const Cutting cutting = cuttingOf(project);
    FormulaSheet sheet{name, "MODEL-8", {}};
    stateContact(&sheet, project, cutting);
    stateTangential(&sheet, project, cutting);
    return sheet;
}

FormulaSheet normalForceSheet(const Project& project, double b, double a) {
    const Cutting cutting = cuttingOf(project);
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Normal force"), "MODEL-2", {}};
    stateContact(&sheet, project, cutting);
    stateNormal(&sheet, project, cutting);
    stateNormalForce(&sheet, cutting.law, b, a);
    return sheet;
}

FormulaSheet tangentialForceSheet(const Project& project, double b, double a) {
    const Cutting cutting = cuttingOf(project);
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Tangential force"), "MODEL-2", {}};
    stateContact(&sheet, project, cutting);
    stateTangential(&sheet, project, cutting);
    stateTangentialForce(&sheet, cutting.law, b, a);
    return sheet;
}

} // namespace sparkout
