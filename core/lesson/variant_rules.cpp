// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/variant_rules.h"

#include "core/project/conditions.h"
#include "core/project/member.h"
#include "core/project/number_input.h"
#include "core/project/validate.h"
#include "core/setup/setup.h"
#include "core/text.h"

#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

bool putText(Project& project, const InputValue& value) {
    const Member member = findMember(project, value.path);
    if (!member) {
        return false;
    }
    if (member.field->kind == Kind::text) {
        member.field->as<std::string>(member.owner) = value.text;
        return true;
    }
    for (std::size_t i = 0; member.field->kind == Kind::choice && i < member.field->choices.size();
         ++i) {
        if (value.text == member.field->choices[i].key) {
            member.field->setChoice(member.owner, static_cast<int>(i));
            return true;
        }
    }
    return false;
}

/// The number in plain decimals: 0.11 + 2·0.01 is 0.13.
double asWrittenInSteps(double value) {
    constexpr double scale = 1e9;
    return std::abs(value) < 1e6 ? std::round(value * scale) / scale : value;
}

} // namespace

bool putInput(Project& project, const InputValue& value) {
    return value.number ? setNumberInput(project, value.path, *value.number)
                        : putText(project, value);
}

bool putInput(Setup& setup, std::size_t surface, const InputValue& value) {
    if (surface >= setup.surfaces.size() || !putInput(setup.surfaces[surface].project, value)) {
        return false;
    }
    if (isShared(value.path)) {
        for (GroundSurface& other : setup.surfaces) {
            copyShared(Project(setup.surfaces[surface].project), other.project);
        }
    }
    return true;
}

template <>
const StructInfo& tableOf<InputValue>() {
    static const std::array rows{
        SPARKOUT_FIELD(InputValue, path, .label = SPARKOUT_NOOP("Input", "Input"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input",
                                             "Its path in a project file, as `/wheel/dullness` or "
                                             "`/cycle/stages/0/stock_mm`.")),
        SPARKOUT_FIELD(InputValue, number, .label = SPARKOUT_NOOP("Input", "Number"),
                       .hard = {-1e9, 1e9}, .nullMeaning = SPARKOUT_NOOP("Input", "the text"),
                       .hint = SPARKOUT_NOOP("Input", "In the unit of the input.")),
        SPARKOUT_FIELD(InputValue, text, .label = SPARKOUT_NOOP("Input", "Text"), .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "A choice by its key, or a name.")),
    };
    static const StructInfo info =
        makeTable<InputValue>(SPARKOUT_NOOP("Struct", "Value of an input"), rows);
    return info;
}

int VariedInput::alternatives() const {
    return ((from || to || step) ? 1 : 0) + (list ? 1 : 0) + (sets.empty() ? 0 : 1);
}

double VariedInput::levels() const {
    constexpr double slack = 1e-6; // a step that ends within this distance reaches the end
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
        SPARKOUT_FIELD(ValueSet, name, .label = SPARKOUT_NOOP("Input", "Name of the set"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Name of the catalogue entry.")),
        SPARKOUT_FIELD(ValueSet, values, .label = SPARKOUT_NOOP("Input", "Values"),
                       .hard = {1, 100}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "They are stored in the lesson itself: later "
                                                      "changes of a catalogue change no variant.")),
    };
    static const StructInfo info =
        makeTable<ValueSet>(SPARKOUT_NOOP("Struct", "Set of values"), rows);
    return info;
}

template <>
const StructInfo& tableOf<VariedInput>() {
    constexpr double largest = 1e9;
    static const std::array rows{
        SPARKOUT_FIELD(
            VariedInput, path, .label = SPARKOUT_NOOP("Input", "Input"), .sparse = true,
            .hint = SPARKOUT_NOOP("Input", "Path of a number of the project, of a range or list.")),
        SPARKOUT_FIELD(VariedInput, from, .label = SPARKOUT_NOOP("Input", "From"),
                       .hard = {-largest, largest},
                       .nullMeaning = SPARKOUT_NOOP("Input", "no range")),
        SPARKOUT_FIELD(VariedInput, to, .label = SPARKOUT_NOOP("Input", "To"),
                       .hard = {-largest, largest},
                       .nullMeaning = SPARKOUT_NOOP("Input", "no range")),
        SPARKOUT_FIELD(VariedInput, step, .label = SPARKOUT_NOOP("Input", "Step"),
                       .hard = {0, largest, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "no range"),
                       .hint = SPARKOUT_NOOP("Input", "The values are the lower end and whole "
                                                      "steps further, up to the upper end.")),
        SPARKOUT_FIELD(VariedInput, list, .label = SPARKOUT_NOOP("Input", "List"),
                       .hard = {-largest, largest},
                       .nullMeaning = SPARKOUT_NOOP("Input", "no list")),
        SPARKOUT_FIELD(VariedInput, sets, .label = SPARKOUT_NOOP("Input", "Sets"),
                       .hard = {0, 1000}, .sparse = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Values that belong together, as entries of a catalogue.")),
    };
    static const StructInfo info =
        makeTable<VariedInput>(SPARKOUT_NOOP("Struct", "Varied input"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Difficulty>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Difficulty, least_time_percent, .label = SPARKOUT_NOOP("Input", "Minimum best time"),
            .unit = "%", .hard = {0, 100},
            .hint = SPARKOUT_NOOP("Input", "Relative to the best time of the original lesson.")),
        SPARKOUT_FIELD(
            Difficulty, most_time_percent, .label = SPARKOUT_NOOP("Input", "Maximum best time"),
            .unit = "%", .hard = {100, 100000},
            .hint = SPARKOUT_NOOP("Input", "Relative to the best time of the original lesson.")),
        SPARKOUT_FIELD(
            Difficulty, margin_within_percent, .label = SPARKOUT_NOOP("Input", "Margin within"),
            .unit = "%", .hard = {0, 1000},
            .hint = SPARKOUT_NOOP(
                "Input", "Largest difference between the minimum relative margin of the best "
                         "answer and that of the original lesson, in percentage points.")),
    };
    static const StructInfo info =
        makeTable<Difficulty>(SPARKOUT_NOOP("Struct", "Difficulty"), rows);
    return info;
}

template <>
const StructInfo& tableOf<FigureBound>() {
    constexpr double largest = 1e9;
    static const std::array rows{
        SPARKOUT_FIELD(FigureBound, figure, .label = SPARKOUT_NOOP("Input", "Figure"),
                       .required = conditions::always),
        SPARKOUT_FIELD(
            FigureBound, step, .label = SPARKOUT_NOOP("Input", "Step"), .hard = {1, 100},
            .sparse = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Number of the step whose initial project has the figure, from 1.")),
        SPARKOUT_FIELD(FigureBound, least, .label = SPARKOUT_NOOP("Input", "Minimum"),
                       .hard = {-largest, largest},
                       .nullMeaning = SPARKOUT_NOOP("Input", "no minimum"),
                       .hint = SPARKOUT_NOOP("Input", "In the unit of the figure.")),
        SPARKOUT_FIELD(FigureBound, most, .label = SPARKOUT_NOOP("Input", "Maximum"),
                       .hard = {-largest, largest},
                       .nullMeaning = SPARKOUT_NOOP("Input", "no maximum"),
                       .hint = SPARKOUT_NOOP("Input", "In the unit of the figure.")),
    };
    static const StructInfo info =
        makeTable<FigureBound>(SPARKOUT_NOOP("Struct", "Bounds of a figure"), rows);
    return info;
}

template <>
const StructInfo& tableOf<VariantRules>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            VariantRules, inputs, .label = SPARKOUT_NOOP("Input", "Varied inputs"), .hard = {1, 20},
            .required = conditions::always,
            .hint = SPARKOUT_NOOP(
                "Input", "Every value of each input is combined with every value of the others.")),
        SPARKOUT_FIELD(
            VariantRules, difficulty, .label = SPARKOUT_NOOP("Input", "Difficulty"),
            .hint = SPARKOUT_NOOP("Input", "Permitted difference between the best answers.")),
        SPARKOUT_FIELD(VariantRules, figures, .label = SPARKOUT_NOOP("Input", "Figures"),
                       .hard = {0, 100}, .sparse = true,
                       .hint = SPARKOUT_NOOP("Input",
                                             "Results that lie within bounds for every variant as "
                                             "given, so that the questions apply to it.")),
        SPARKOUT_FIELD(
            VariantRules, surface, .label = SPARKOUT_NOOP("Input", "Surface"), .hard = {1, 20},
            .hint =
                SPARKOUT_NOOP("Input", "Number of the surface whose inputs are varied, from 1.")),
    };
    static const StructInfo info =
        makeTable<VariantRules>(SPARKOUT_NOOP("Struct", "Variants"), rows);
    return info;
}

} // namespace sparkout
