// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/figure.h"
#include "core/lesson/input_value.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// How the variants of a lesson differ. It stands in the teacher's file alone.
namespace sparkout {

namespace limits {
inline constexpr std::size_t levelsOfInput = 10'000;
} // namespace limits

/// Values that belong together, as those of an entry of a catalogue.
struct ValueSet {
    std::string name;
    std::vector<InputValue> values;
};

/// An input that the variants vary: over a range in steps, over a list, or over sets of values.
/// Exactly one of them is given.
struct VariedInput {
    std::string path;               ///< of a range or list
    std::optional<double> from, to; ///< both ends may come
    std::optional<double> step;
    std::optional<std::vector<double>> list;
    std::vector<ValueSet> sets;

    [[nodiscard]] bool isRange() const { return from && to && step; }
    [[nodiscard]] int alternatives() const; ///< that are given
    [[nodiscard]] double levels() const;    ///< how many there are
    /// What a level puts into a project, from 0.
    [[nodiscard]] std::vector<InputValue> valuesAt(std::size_t level) const;
    /// The level as a table states it: its number, or the name of the set.
    [[nodiscard]] std::string nameOf(std::size_t level) const;
};

/// How far the best answer of a variant may be from that of the lesson as it stands.
struct Difficulty {
    double least_time_percent = 70; ///< of the lesson's best time [%]
    double most_time_percent = 140; ///< of the lesson's best time [%]
    double margin_within_percent =
        10; ///< of the least relative margin, either way [percentage points]
};

/// A figure that every variant has within bounds as a step begins: what the questions rest on.
struct FigureBound {
    Figure figure;
    int step = 1; ///< from 1
    std::optional<double> least, most;
};

struct VariantRules {
    std::vector<VariedInput> inputs;
    Difficulty difficulty;
    std::vector<FigureBound> figures;
    int surface = 1; ///< whose inputs are varied, from 1
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
