// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/wheel_wear.h"

#include "core/process/recipe_force.h"
#include "core/project/wheel.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sparkout {

Wheel wheelAfter(const Wheel& dressed, const WheelWear& wear, double removed_mm3) {
    Wheel wheel = dressed;
    if (removed_mm3 <= 0) {
        return wheel;
    }
    if (wear.dulling_per_mm2) {
        const double grown = std::pow(removed_mm3 / dressed.width_mm, wear.dulling_exponent);
        setDullness(wheel, std::min(1.0, dullnessOf(dressed) + *wear.dulling_per_mm2 * grown));
    }
    if (wear.grinding_ratio) {
        const double worn_mm3 = removed_mm3 / *wear.grinding_ratio;
        const double square = dressed.diameter_mm * dressed.diameter_mm
                              - 4 * worn_mm3 / (std::numbers::pi * dressed.width_mm);
        wheel.diameter_mm = std::sqrt(std::max(square, 0.0));
    }
    return wheel;
}

template <>
const StructInfo& tableOf<WheelWear>() {
    static const std::array rows{
        SPARKOUT_FIELD(WheelWear, dulling_per_mm2, .label = SPARKOUT_NOOP("Input", "Dulling"),
                       .symbol = "c", .unit = "1/mm²", .hard = {0, 1}, .soft = {0, 1e-3},
                       .nullMeaning = SPARKOUT_NOOP("Input", "the wheel stays as sharp"),
                       .hint = SPARKOUT_NOOP("Input",
                                             "By how much the dullness grows for each mm³ that a "
                                             "millimetre of the wheel's width has removed."),
                       .formula = "η = η_0 + c·(V_w/B)ᵖ", .source = "MODEL-12"),
        SPARKOUT_FIELD(
            WheelWear, dulling_exponent, .label = SPARKOUT_NOOP("Input", "Exponent of dulling"),
            .symbol = "p", .hard = {0.1, 5}, .soft = {0.3, 2},
            .hint = SPARKOUT_NOOP("Input", "1: the dullness grows evenly. Below 1 it grows most "
                                           "just after dressing, above 1 towards the end; the "
                                           "dulling is then counted per mm² to this power."),
            .formula = "η = η_0 + c·(V_w/B)ᵖ", .source = "MODEL-12"),
        SPARKOUT_FIELD(WheelWear, grinding_ratio, .label = SPARKOUT_NOOP("Input", "Grinding ratio"),
                       .symbol = "G", .hard = {0.01, 1000000}, .soft = {1, 100000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "the wheel keeps its diameter"),
                       .hint = SPARKOUT_NOOP("Input", "Volume removed from the parts for each "
                                                      "volume of the wheel that wears off."),
                       .formula = "V_w/G = π·B·(D_0² − D²)/4", .source = "MODEL-12"),
    };
    static const StructInfo info =
        makeTable<WheelWear>(SPARKOUT_NOOP("Struct", "Wheel wear"), rows);
    return info;
}

} // namespace sparkout
