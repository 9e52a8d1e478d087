// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/variant_rules.h"

#include "core/project/conditions.h"
#include "core/project/validate.h"

#include <array>
#include <cmath>

namespace sparkout {

namespace {

/// The number as one would write it: 0.11 + 2·0.01 is 0.13.
double asWrittenInSteps(double value) {
    constexpr double scale = 1e9;
    return std::abs(value) < 1e6 ? std::round(value * scale) / scale : value;
}

} // namespace

int VariedInput::alternatives() const {
    return ((from || to || step) ? 1 : 0) + (list ? 1 : 0) + (sets.empty() ? 0 : 1);
}

double VariedInput::levels() const {
    constexpr double slack = 1e-6; // a step that ends this near to the end reaches it
    if (isRange()) {
        return *to < *from ? 0 : std::floor((*to - *from) / *step + slack) + 1;
    }
    return static_cast<double>(list ? list->size() : sets.size());
}

std::vector<InputValue> VariedInput::valuesAt(std::size_t level) const {
    if (isRange()) {
        return {{path, asWrittenInSteps(*from + static_cast<double>(level) * *step), {}}};
    }
    return list ? std::vector<InputValue>{{path, (*list)[level], {}}} : sets[level].values;
}

std::string VariedInput::nameOf(std::size_t level) const {
    return sets.empty() ? numberText(*valuesAt(level).front().number) : sets[level].name;
}

template <>
const StructInfo& tableOf<ValueSet>() {
    static const std::array rows{
        SPARKOUT_FIELD(ValueSet, name, .label = "Name", .required = conditions::always,
                       .hint = "As the entry of the catalogue is called."),
        SPARKOUT_FIELD(ValueSet, values, .label = "Values", .hard = {1, 100},
                       .required = conditions::always,
                       .hint = "They stand in the lesson itself: a catalogue that changes later "
                               "changes no variant."),
    };
    static const StructInfo info = makeTable<ValueSet>("Set of values", rows);
    return info;
}

template <>
const StructInfo& tableOf<VariedInput>() {
    constexpr double largest = 1e9;
    static const std::array rows{
        SPARKOUT_FIELD(VariedInput, path, .label = "Input", .sparse = true,
                       .hint = "Path of a number of the project, of a range or list."),
        SPARKOUT_FIELD(VariedInput, from, .label = "From", .hard = {-largest, largest},
                       .nullMeaning = "no range"),
        SPARKOUT_FIELD(VariedInput, to, .label = "To", .hard = {-largest, largest},
                       .nullMeaning = "no range"),
        SPARKOUT_FIELD(VariedInput, step, .label = "Step", .hard = {0, largest, true},
                       .nullMeaning = "no range",
                       .hint = "Values are `from` and whole steps further, up to `to`."),
        SPARKOUT_FIELD(VariedInput, list, .label = "List", .hard = {-largest, largest},
                       .nullMeaning = "no list"),
        SPARKOUT_FIELD(VariedInput, sets, .label = "Sets", .hard = {0, 1000}, .sparse = true,
                       .hint = "Values that belong together, as entries of a catalogue."),
    };
    static const StructInfo info = makeTable<VariedInput>("Input varied", rows);
    return info;
}

template <>
const StructInfo& tableOf<Difficulty>() {
    static const std::array rows{
        SPARKOUT_FIELD(Difficulty, least_time_percent, .label = "Minimum best time", .unit = "%",
                       .hard = {0, 100}, .hint = "Of the best time of the lesson as it stands."),
        SPARKOUT_FIELD(Difficulty, most_time_percent, .label = "Maximum best time", .unit = "%",
                       .hard = {100, 100000}, .hint = "Likewise."),
        SPARKOUT_FIELD(Difficulty, margin_within_percent, .label = "Margin within", .unit = "%",
                       .hard = {0, 1000},
                       .hint = "How far the least relative margin of the best answer may be from "
                               "that of the lesson as it stands, in percentage points."),
    };
    static const StructInfo info = makeTable<Difficulty>("Difficulty", rows);
    return info;
}

template <>
const StructInfo& tableOf<FigureBound>() {
    constexpr double largest = 1e9;
    static const std::array rows{
        SPARKOUT_FIELD(FigureBound, figure, .label = "Figure", .required = conditions::always),
        SPARKOUT_FIELD(FigureBound, step, .label = "Step", .hard = {1, 100}, .sparse = true,
                       .hint = "As it begins; counted from 1."),
        SPARKOUT_FIELD(FigureBound, least, .label = "Minimum", .hard = {-largest, largest},
                       .nullMeaning = "no minimum", .hint = "In the unit of the figure."),
        SPARKOUT_FIELD(FigureBound, most, .label = "Maximum", .hard = {-largest, largest},
                       .nullMeaning = "no maximum", .hint = "Likewise."),
    };
    static const StructInfo info = makeTable<FigureBound>("Bounds of a figure", rows);
    return info;
}

template <>
const StructInfo& tableOf<VariantRules>() {
    static const std::array rows{
        SPARKOUT_FIELD(VariantRules, inputs, .label = "Inputs varied", .hard = {1, 20},
                       .required = conditions::always),
        SPARKOUT_FIELD(VariantRules, difficulty, .label = "Difficulty",
                       .hint = "What the best answers may differ by."),
        SPARKOUT_FIELD(VariantRules, figures, .label = "Figures", .hard = {0, 100}, .sparse = true,
                       .hint = "What every variant has within bounds as given, so that the "
                               "questions are true of it."),
        SPARKOUT_FIELD(VariantRules, surface, .label = "Surface", .hard = {1, 20},
                       .hint = "Whose inputs are varied, from 1."),
    };
    static const StructInfo info = makeTable<VariantRules>("Variants", rows);
    return info;
}

} // namespace sparkout
