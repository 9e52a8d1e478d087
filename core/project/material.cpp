// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/material.h"

#include "core/project/conditions.h"
#include "core/text.h"

namespace sparkout {

namespace {

bool byThreshold(const Project& p, const void*) {
    return p.material->force_law == ForceLawKind::threshold;
}
bool bySources(const Project& p, const void* owner) {
    return !byThreshold(p, owner);
}

} // namespace

template <>
std::span<const Choice> choicesOf<ForceLawKind>() {
    static const std::array choices{
        Choice{"sources", SPARKOUT_NOOP("Choice", "with √a, of the sources")},
        Choice{"threshold", SPARKOUT_NOOP("Choice", "with a threshold")}};
    return choices;
}

template <>
const StructInfo& tableOf<Material>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Material, grade, .label = SPARKOUT_NOOP("Input", "Grade"), .page = Page::material,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Steel or iron grade, as it stands in the drawing.")),
        SPARKOUT_FIELD(
            Material, hardness_hrc, .label = SPARKOUT_NOOP("Input", "Hardness"), .symbol = "HRC",
            .unit = "HRC", .hard = {0, 75}, .soft = {15, 68},
            .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .page = Page::material,
            .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Hardness of the part; for the record, as the force law uses the flow stress.")),
        SPARKOUT_FIELD(Material, flow_stress_mpa, .label = SPARKOUT_NOOP("Input", "Flow stress"),
                       .symbol = "σ_i", .unit = "MPa", .hard = {10, 20000}, .soft = {300, 4000},
                       .required = conditions::always, .relevant = bySources, .slider = true,
                       .page = Page::material, .usual = true,
                       .hint = SPARKOUT_NOOP("Input",
                                             "Stress intensity of the metal in the cutting zone: "
                                             "k_s = ε_i·tg β·σ_i·V_d/V_k, k_r = η·σ_i·√D_e/3."),
                       .source = "MODEL-2"),
        SPARKOUT_FIELD(Material, shear_factor, .label = SPARKOUT_NOOP("Input", "Shear factor"),
                       .symbol = "ε_i·tg β", .hard = {0.01, 100}, .soft = {1, 4},
                       .page = Page::material,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Shear strain intensity times the tangent of the force angle, "
                                    "in the normal force."),
                       .formula = "k_s = ε_i·tg β·σ_i·V_d/V_k", .source = "MODEL-1"),
        SPARKOUT_FIELD(Material, shear_strain, .label = SPARKOUT_NOOP("Input", "Shear strain"),
                       .symbol = "ε_i", .hard = {0.01, 100}, .soft = {1, 6}, .page = Page::material,
                       .hint =
                           SPARKOUT_NOOP("Input", "Shear strain intensity, in the tangential force "
                                                  "P_z = b·(ε_i·σ_i·V_d/V_k·a + μ·k_r·√a)."),
                       .source = "MODEL-2"),
        SPARKOUT_FIELD(
            Material, friction, .label = SPARKOUT_NOOP("Input", "Friction"), .symbol = "μ",
            .hard = {0, 2}, .soft = {0.1, 0.6}, .page = Page::material,
            .hint = SPARKOUT_NOOP("Input", "Coefficient of friction of wear flats on metal."),
            .formula = "P_z = b·(ε_i·σ_i·V_d/V_k·a + μ·k_r·√a)", .source = "MODEL-2"),
        SPARKOUT_FIELD(Material, force_law, .label = SPARKOUT_NOOP("Input", "Force law"),
                       .sparse = true, .page = Page::material,
                       .hint = SPARKOUT_NOOP(
                           "Input",
                           "With a threshold nothing is cut below the force F′_0, and a spark-out "
                           "ends exponentially; flow stress and dullness do not enter the force."),
                       .formula = "P_y = b·(F′_0 + K·a)", .source = "HON585"),
        SPARKOUT_FIELD(
            Material, threshold_force_n_mm, .label = SPARKOUT_NOOP("Input", "Threshold force"),
            .symbol = "F′_0", .unit = "N/mm", .hard = {0, 1000}, .soft = {0.05, 10},
            .relevant = byThreshold, .sparse = true, .page = Page::material,
            .hint = SPARKOUT_NOOP(
                "Input", "Normal force per millimetre of width up to which the wheel only rubs. It "
                         "is found from a recorded spark-out, whose remainder is γ·b·F′_0."),
            .formula = "P_y = b·(F′_0 + K·a)", .source = "HON585"),
        SPARKOUT_FIELD(
            Material, specific_force_mpa, .label = SPARKOUT_NOOP("Input", "Specific normal force"),
            .symbol = "K_0", .unit = "MPa", .hard = {1, 1e8}, .soft = {2000, 500000},
            .relevant = byThreshold, .sparse = true, .page = Page::material,
            .hint = SPARKOUT_NOOP("Input", "Normal force per area of chip, beyond the threshold. "
                                           "It is found from the time constant of a recorded "
                                           "spark-out."),
            .formula = "K = K_0·V_d/V_k", .source = "HON585"),
        SPARKOUT_FIELD(
            Material, specific_tangential_force_mpa,
            .label = SPARKOUT_NOOP("Input", "Specific tangential force"), .symbol = "K_z0",
            .unit = "MPa", .hard = {1, 1e8}, .soft = {1000, 500000},
            .nullMeaning = SPARKOUT_NOOP("Input", "K_0·ε_i/(ε_i·tg β), as in the sources' law"),
            .relevant = byThreshold, .sparse = true, .page = Page::material,
            .hint = SPARKOUT_NOOP("Input", "Tangential force per area of chip, beyond the friction "
                                           "at the threshold; it determines the power."),
            .formula = "P_z = b·(K_z0·V_d/V_k·a + μ·F′_0)", .source = "MODEL-2"),
        SPARKOUT_FIELD(Material, conductivity_w_mk,
                       .label = SPARKOUT_NOOP("Input", "Thermal conductivity"), .symbol = "λ",
                       .unit = "W/(m·K)", .hard = {0.1, 1000}, .soft = {10, 80},
                       .page = Page::material,
                       .hint = SPARKOUT_NOOP("Input", "Value of the part near the surface."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Material, diffusivity_mm2_s,
                       .label = SPARKOUT_NOOP("Input", "Thermal diffusivity"), .symbol = "Ω",
                       .unit = "mm²/s", .hard = {0.01, 500}, .soft = {3, 20},
                       .page = Page::material,
                       .hint = SPARKOUT_NOOP("Input", "Value of the part near the surface."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Material, burn_rise_k,
                       .label = SPARKOUT_NOOP("Input", "Burn temperature rise"), .symbol = "U",
                       .unit = "K", .hard = {10, 3000}, .soft = {200, 1000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "burn not checked"),
                       .page = Page::material, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Temperature rise above which the metal's structure changes."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Material, heat_share, .label = SPARKOUT_NOOP("Input", "Heat into the part"),
            .symbol = "ε_w", .hard = {0, 1, true}, .soft = {0.05, 1}, .page = Page::material,
            .hint = SPARKOUT_NOOP("Input", "Share of the grinding heat that enters the part."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Material, expansion_um_m_k, .label = SPARKOUT_NOOP("Input", "Thermal expansion"),
            .symbol = "α", .unit = "10⁻⁶/K", .hard = {0, 100}, .soft = {5, 25}, .sparse = true,
            .page = Page::material,
            .hint = SPARKOUT_NOOP("Input", "Growth of one metre of the part per kelvin; the gauge "
                                           "reads a warm part too large by it."),
            .formula = "α·d·ΔT", .source = "MODEL-7"),
    };
    static const StructInfo info = makeTable<Material>(SPARKOUT_NOOP("Struct", "Material"), rows);
    return info;
}

} // namespace sparkout
