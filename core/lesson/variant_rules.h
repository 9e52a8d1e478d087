// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/figure.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Rules for the variants of a lesson. Only the teacher's file contains them.
namespace sparkout {

struct Project;
struct Setup;

/// A value that a lesson puts into a project: a number, or a text for a choice or a name.
struct InputValue {
    std::string path; ///< path of the input, "/wheel/dullness"
    std::optional<double> number;
    std::string text; ///< used without a number
    friend bool operator==(const InputValue&, const InputValue&) = default;
};

/// Sets an input; false if the project has none that takes the value.
[[nodiscard]] bool putInput(Project& project, const InputValue& value);

/// Sets an input in a surface of a set-up, or in all of them if they share it.
[[nodiscard]] bool putInput(Setup& setup, std::size_t surface, const InputValue& value);

template <>
const StructInfo& tableOf<InputValue>();

namespace limits {
inline constexpr std::size_t levelsOfInput = 10'000;
} // namespace limits

/// Values that belong together, such as those of a catalogue entry.
struct ValueSet {
    std::string name;
    std::vector<InputValue> values;
};

/// An input that the variants vary: over a range in steps, over a list, or over sets of values.
/// Exactly one of them is given.
struct VariedInput {
    std::string path;               ///< input of a range or list
    std::optional<double> from, to; ///< both ends included
    std::optional<double> step;
    std::optional<std::vector<double>> list;
    std::vector<ValueSet> sets;

    [[nodiscard]] bool isRange() const { return from && to && step; }
    [[nodiscard]] int alternatives() const; ///< number of forms that are given
    [[nodiscard]] double levels() const;    ///< number of levels
    /// The values of a level, counted from 0.
    [[nodiscard]] std::vector<InputValue> valuesAt(std::size_t level) const;
    /// The name of the level in a table: its number, or the name of the set.
    [[nodiscard]] std::string nameOf(std::size_t level) const;
};

/// The allowed distance of a variant's best answer from that of the original lesson.
struct Difficulty {
    double least_time_percent = 70; ///< share of the lesson's best time [%]
    double most_time_percent = 140; ///< share of the lesson's best time [%]
    double margin_within_percent =
        10; ///< deviation of the least relative margin, ± [percentage points]
};

/// Bounds of a figure that every variant meets as a step begins, so that the questions apply.
struct FigureBound {
    Figure figure;
    int step = 1; ///< counted from 1
    std::optional<double> least, most;
};

struct VariantRules {
    std::vector<VariedInput> inputs;
    Difficulty difficulty;
    std::vector<FigureBound> figures;
    int surface = 1; ///< surface whose inputs are varied, from 1
};

template <>
const StructInfo& tableOf<ValueSet>();
template <>
const StructInfo& tableOf<VariedInput>();
template <>
const StructInfo& tableOf<Difficulty>();
template <>
const StructInfo& tableOf<FigureBound>();
template <>
const StructInfo& tableOf<VariantRules>();

} // namespace sparkout
