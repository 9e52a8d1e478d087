// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/wheel_wear.h"

#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/wheel.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace sparkout {

namespace {

/// D of a wheel worn by a volume over a width.
double wornDiameter(double dressed_mm, double worn_mm3, double width_mm) {
    const double square = dressed_mm * dressed_mm - 4 * worn_mm3 / (std::numbers::pi * width_mm);
    return std::sqrt(std::max(square, 0.0));
}

} // namespace

RemovedMetal removedMetal(const Project& project, double volume_mm3) {
    const double contact_mm =
        project.operation->travels ? project.wheel->width_mm : project.part->length_mm;
    return {volume_mm3, volume_mm3 / contact_mm};
}

Wheel wheelAfter(const Wheel& dressed, const WheelWear& wear, const RemovedMetal& removed) {
    Wheel wheel = dressed;
    if (removed.volume_mm3 <= 0) {
        return wheel;
    }
    if (wear.dulling_per_mm2) {
        const double grown = std::pow(removed.volume_mm3 / dressed.width_mm, wear.dulling_exponent);
        setDullness(wheel, std::min(1.0, dullnessOf(dressed) + *wear.dulling_per_mm2 * grown));
    }
    if (const std::optional<double>& ratio = wear.grinding_ratio) {
        wheel.diameter_mm =
            wornDiameter(dressed.diameter_mm, removed.volume_mm3 / *ratio, dressed.width_mm);
        const double ground_mm =
            wornDiameter(dressed.diameter_mm, removed.perContact_mm2 / *ratio, 1);
        wheel.radius_wear_um += (dressed.diameter_mm - ground_mm) / 2 * units::umPerMm;
    }
    return wheel;
}

void wearWheel(Project& project, const WheelWear& wear, const RemovedMetal& removed) {
    Wheel worn = wheelAfter(*project.wheel, wear, removed);
    changeWheelDiameter(project, worn.diameter_mm);
    *project.wheel = std::move(worn);
}

bool isWornOut(const Wheel& dressed, const WheelWear& wear, const RemovedMetal& removed) {
    const bool asDullAsCanBe = wear.dulling_per_mm2.value_or(0) == 0
                               || dullnessOf(wheelAfter(dressed, wear, removed)) >= 1;
    return asDullAsCanBe && !wear.grinding_ratio;
}

template <>
const StructInfo& tableOf<WheelWear>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            WheelWear, dulling_per_mm2, .label = SPARKOUT_NOOP("Input", "Dulling"), .symbol = "c",
            .unit = "1/mm²", .hard = {0, 1}, .soft = {0, 1e-3},
            .nullMeaning = SPARKOUT_NOOP("Input", "the wheel stays as sharp"),
            .hint = SPARKOUT_NOOP(
                "Input",
                "Growth of the dullness per mm³ removed by each millimetre of the wheel's width."),
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
