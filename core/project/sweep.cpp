// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/sweep.h"

#include "core/project/conditions.h"
#include "core/text.h"

namespace sparkout {

template <>
std::span<const Choice> choicesOf<SweepSpacing>() {
    static const std::array choices{Choice{"linear", SPARKOUT_NOOP("Choice", "equal steps")},
                                    Choice{"logarithmic", SPARKOUT_NOOP("Choice", "equal ratios")}};
    return choices;
}

template <>
const StructInfo& tableOf<SweepAxis>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            SweepAxis, input, .label = SPARKOUT_NOOP("Input", "Input"),
            .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input", "Path of any number of the file that a cycle reads, as "
                                           "`/wheel/dullness` or `/cycle/stages/0/stock_mm`.")),
        SPARKOUT_FIELD(SweepAxis, from, .label = SPARKOUT_NOOP("Input", "From"),
                       .hard = {-1e9, 1e9}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Minimum value, in the unit of the input.")),
        SPARKOUT_FIELD(SweepAxis, to, .label = SPARKOUT_NOOP("Input", "To"), .hard = {-1e9, 1e9},
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Maximum value, in the unit of the input.")),
        SPARKOUT_FIELD(SweepAxis, points, .label = SPARKOUT_NOOP("Input", "Points"),
                       .hard = {2, 101},
                       .hint = SPARKOUT_NOOP("Input", "Number of values, both ends included.")),
        SPARKOUT_FIELD(SweepAxis, spacing, .label = SPARKOUT_NOOP("Input", "Spacing"),
                       .hint = SPARKOUT_NOOP("Input", "By equal steps, or by equal ratios of "
                                                      "positive values (logarithmic).")),
    };
    static const StructInfo info =
        makeTable<SweepAxis>(SPARKOUT_NOOP("Struct", "Varied input"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Sweep>() {
    static const std::array rows{
        SPARKOUT_FIELD(Sweep, inputs, .label = SPARKOUT_NOOP("Input", "Varied inputs"),
                       .hard = {1, 2}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "One for curves, two for a map.")),
    };
    static const StructInfo info = makeTable<Sweep>(SPARKOUT_NOOP("Struct", "Sweep"), rows);
    return info;
}

} // namespace sparkout
