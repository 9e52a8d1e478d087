// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <optional>
#include <span>

namespace sparkout {

/// A zone or section as named in a file: "rz1", "nz", "rz2", or the number of a section from 0; as
/// an input a CountOrWord.
struct PlaceName {
    std::optional<int> zone;    ///< index of the word
    std::optional<int> section; ///< counted from 0
    friend bool operator==(const PlaceName&, const PlaceName&) = default;

    [[nodiscard]] bool isGiven() const { return zone || section; }
    /// The index in SimulationResult::sections.
    [[nodiscard]] std::size_t index() const {
        return static_cast<std::size_t>(zone.value_or(section.value_or(0)));
    }

    [[nodiscard]] static std::span<const Choice> words();
    [[nodiscard]] static Phrase expected();
    [[nodiscard]] static PlaceName ofNumber(int number) { return {std::nullopt, number}; }
    [[nodiscard]] static PlaceName ofWord(std::size_t word) {
        return {static_cast<int>(word), std::nullopt};
    }
    [[nodiscard]] int* number() { return section ? &*section : nullptr; }
    [[nodiscard]] std::optional<std::size_t> word() const {
        return zone ? std::optional(static_cast<std::size_t>(*zone)) : std::nullopt;
    }
};

struct Project;

/// The name of a place of a project by its index.
[[nodiscard]] PlaceName placeName(const Project& project, std::size_t index);
/// Whether a project has such a place.
[[nodiscard]] bool hasPlace(const Project& project, const PlaceName& place);

/// A figure that a student can read off a run, by its name in files.
enum class FigureName {
    // cycle
    cycleTime,
    steps,
    diameterSpread,
    cylindricity,
    totalRunout,
    taper,
    crown,
    peakForce,
    peakPower,
    leastMargin,
    burnMargin,
    removalRate,
    specificEnergy,
    // project
    equivalentDiameter,
    shearCoefficient,
    flatCoefficient,
    burnFreeFeed,
    // stage
    stageSteps,
    stageTime,
    stageDepth,
    stageForce,
    stagePower,
    // zone or section
    compliance,
    deviationLeast,
    deviationMost,
    deviationMean,
    radialRunout,
    roundness,
    roughness,
    placeForce,
    // double stroke or revolution, or one of its steps, in a zone or section
    programmedFeed,
    actualFeed,
    lag,
    accumulatedFeed,
    stockLeft,
    force,
    runoutAfter,
    damagedLayer,
    burnLimit,
    // batch, and the mean diameter of a zone or section over it
    batchBad,
    batchMean,
    batchDeviation,
    batchMeanHalf,
    batchPp,
    batchPpk,
    // search
    bestTime,
    levelsBestTime,
    levelsRuleTime,
    levelsRuleGap,
    count_
};

/// The scope of a figure.
enum class FigureScope { cycle, stage, place, step, batch, batchPlace, search };

/// A figure that a lesson asks for. Members that its scope does not need are not given.
struct Figure {
    FigureName name = FigureName::cycleTime;
    PlaceName place;
    std::optional<int> stage; ///< counted from 1
    std::optional<int> count; ///< double stroke or revolution from 1; not given: the last one
    Step step = Step::none;   ///< none: the whole double stroke or revolution
    friend bool operator==(const Figure&, const Figure&) = default;
};

/// The properties of a figure.
struct FigureRow {
    FigureName name;
    Choice choice; ///< key in files and label
    const char* unit;
    int digits; ///< number of readable decimals
    FigureScope scope;
    bool ofSurface; ///< known for the cut part alone where strips stay uncut
};

[[nodiscard]] const FigureRow& rowOf(FigureName name);

/// Whether it is of one zone or section.
[[nodiscard]] constexpr bool isOfPlace(FigureScope scope) {
    return scope == FigureScope::place || scope == FigureScope::step
           || scope == FigureScope::batchPlace;
}

/// Whether a run has to be recorded for it.
[[nodiscard]] inline bool needsTrajectory(const Figure& figure) {
    return rowOf(figure.name).scope == FigureScope::step;
}

template <>
std::span<const Choice> choicesOf<FigureName>();
template <>
std::span<const Choice> choicesOf<Step>();
template <>
const StructInfo& tableOf<Figure>();

} // namespace sparkout
