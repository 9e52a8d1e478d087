// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/cutting.h"

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
    cutting.dullness = project.wheel->dullness;
    return cutting;
}

namespace {

// The coefficients come out of forceLaw(); what is said of them here is held against it by a test.

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
}

void stateNormal(FormulaSheet* sheet, const Project& project, const Cutting& cutting) {
    state(sheet, "{k_s} = {ε_i·tg β}·{σ_i}·{V_d}/{V_k}", {"k_s", cutting.law.ks, "MPa"},
          {{"ε_i·tg β", project.material->shear_factor, ""},
           {"σ_i", project.material->flow_stress_mpa, "MPa"},
           {"V_d", cutting.Vd_mm_s, "mm/s"},
           {"V_k", cutting.Vk_mm_s, "mm/s"}});
    stateFriction(sheet, project, cutting);
}

void stateTangential(FormulaSheet* sheet, const Project& project, const Cutting& cutting) {
    state(sheet, "{k_t} = {ε_i}·{σ_i}·{V_d}/{V_k}", {"k_t", cutting.law.kt, "MPa"},
          {{"ε_i", project.material->shear_strain, ""},
           {"σ_i", project.material->flow_stress_mpa, "MPa"},
           {"V_d", cutting.Vd_mm_s, "mm/s"},
           {"V_k", cutting.Vk_mm_s, "mm/s"}});
    stateFriction(sheet, project, cutting);
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
    state(&sheet, "{P_y} = {b}·({k_s}·{a} + {k_r}·√({a}))",
          {"P_y", cutting.law.normal(b, std::sqrt(a)), "N"},
          {{"b", b, "mm"},
           {"k_s", cutting.law.ks, "MPa"},
           {"a", a, "mm"},
           {"k_r", cutting.law.kr, "N/mm^1.5"}});
    return sheet;
}

FormulaSheet tangentialForceSheet(const Project& project, double b, double a) {
    const Cutting cutting = cuttingOf(project);
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Tangential force"), "MODEL-2", {}};
    stateContact(&sheet, project, cutting);
    stateTangential(&sheet, project, cutting);
    state(&sheet, "{P_z} = {b}·({k_t}·{a} + {μ}·{k_r}·√({a}))",
          {"P_z", cutting.law.tangential(b, std::sqrt(a)), "N"},
          {{"b", b, "mm"},
           {"k_t", cutting.law.kt, "MPa"},
           {"a", a, "mm"},
           {"μ", cutting.law.mu, ""},
           {"k_r", cutting.law.kr, "N/mm^1.5"}});
    return sheet;
}

} // namespace sparkout
