// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/wheel.h"

#include "core/project/conditions.h"
#include "core/text.h"

namespace sparkout {

template <>
const StructInfo& tableOf<Wheel>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Wheel, marking, .label = SPARKOUT_NOOP("Input", "Marking"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Marking of the wheel, for example 25А F60 L 6 V.")),
        SPARKOUT_FIELD(Wheel, diameter_mm, .label = SPARKOUT_NOOP("Input", "Wheel diameter"),
                       .symbol = "D", .unit = "mm", .hard = {0.5, 2000}, .soft = {5, 1100},
                       .required = conditions::always, .page = Page::wheel,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Diameter of the wheel; D_e = d·D/(D ± d) sets the contact "
                                    "length √(a·D_e)."),
                       .source = "MODEL-1"),
        SPARKOUT_FIELD(Wheel, width_mm, .label = SPARKOUT_NOOP("Input", "Wheel width"),
                       .symbol = "B", .unit = "mm", .hard = {0.5, 1000}, .soft = {3, 250},
                       .required = conditions::always, .page = Page::wheel,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Width of the wheel. A plunge wheel covers the ground length."),
                       .formula = "b = min(S_ax/n, B)", .source = "MODEL-1"),
        SPARKOUT_FIELD(Wheel, dullness, .label = SPARKOUT_NOOP("Input", "Dullness"), .symbol = "η",
                       .hard = {0, 1}, .soft = {0.005, 0.25}, .required = conditions::always,
                       .slider = true, .page = Page::wheel,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Share of the working surface that is wear flats: 0 is ideally "
                                    "sharp. It drives the friction term k_r = η·σ_i·√D_e/3."),
                       .source = "MODEL-2"),
        SPARKOUT_FIELD(Wheel, grain_mm, .label = SPARKOUT_NOOP("Input", "Grain size"),
                       .symbol = "d_g", .unit = "mm", .hard = {0.001, 5}, .soft = {0.05, 1},
                       .page = Page::wheel, .hint = SPARKOUT_NOOP("Input", "Mean grain size."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, grain_share, .label = SPARKOUT_NOOP("Input", "Grain share"),
                       .symbol = "W_g", .hard = {0.01, 0.6199}, .soft = {0.38, 0.6},
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Share of grain in the wheel's volume."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, bond_share, .label = SPARKOUT_NOOP("Input", "Bond share"),
                       .symbol = "W_b", .hard = {0.001, 0.6}, .soft = {0.02, 0.3},
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Share of bond in the wheel's volume."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, grain_tip_angle_deg, .label = SPARKOUT_NOOP("Input", "Grain tip angle"),
            .symbol = "φ", .unit = "°", .hard = {1, 89}, .soft = {30, 75}, .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Angle of the grain tips."), .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, dressing_chipping_mm,
                       .label = SPARKOUT_NOOP("Input", "Dressing chipping level"), .symbol = "Δ",
                       .unit = "mm", .hard = {1e-6, 10}, .soft = {0.005, 0.5}, .page = Page::wheel,
                       .hint =
                           SPARKOUT_NOOP("Input", "Depth over which dressing chips the grains."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, roughness_factor, .label = SPARKOUT_NOOP("Input", "Roughness calibration"),
            .hard = {0, 100, true}, .soft = {0.2, 10}, .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Measured Ra over computed Ra."), .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, grain_surface_energy_j_m2,
                       .label = SPARKOUT_NOOP("Input", "Grain surface energy"), .symbol = "γ_g",
                       .unit = "J/m²", .hard = {0, 1e4, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Fracture surface energy of the grain."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, grain_modulus_gpa, .label = SPARKOUT_NOOP("Input", "Grain modulus"),
                       .symbol = "E_g", .unit = "GPa", .hard = {0, 2000, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Young's modulus of the grain."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, bond_surface_energy_j_m2,
                       .label = SPARKOUT_NOOP("Input", "Bond surface energy"), .symbol = "γ_b",
                       .unit = "J/m²", .hard = {0, 1e4, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Fracture surface energy of the bond."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, bond_modulus_gpa, .label = SPARKOUT_NOOP("Input", "Bond modulus"),
                       .symbol = "E_b", .unit = "GPa", .hard = {0, 2000, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Young's modulus of the bond."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, bond_bridge_mm, .label = SPARKOUT_NOOP("Input", "Bond bridge"), .symbol = "D_b",
            .unit = "mm", .hard = {0, 10, true},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the grain lattice"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Diameter of a bond bridge."), .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, grains_per_mm2, .label = SPARKOUT_NOOP("Input", "Grains per area"),
            .symbol = "n_g", .unit = "1/mm²", .hard = {0, 1e6, true},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the grain lattice"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Grains on a square millimetre of the wheel."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, max_speed_m_s, .label = SPARKOUT_NOOP("Input", "Highest wheel speed"),
                       .symbol = "V_m", .unit = "m/s", .hard = {1, 400}, .soft = {15, 160},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Working speed marked on the wheel, which "
                                                      "the machine may not exceed.")),
        SPARKOUT_FIELD(Wheel, dressing, .label = SPARKOUT_NOOP("Input", "Dressing"), .sparse = true,
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Dressing tool and how it is used, for the "
                                                      "operation card.")),
    };
    static const StructInfo info = makeTable<Wheel>(SPARKOUT_NOOP("Struct", "Wheel"), rows);
    return info;
}

} // namespace sparkout
