// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/place_name.h"
#include "core/simulation/result.h"

#include <optional>

namespace sparkout {

/// A figure that a student can read off a run, by its name in files.
enum class FigureName {
    // of the cycle
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
    // of what is ground with what, and how fast: of the project
    equivalentDiameter,
    shearCoefficient,
    flatCoefficient,
    burnFreeFeed,
    // of a stage
    stageSteps,
    stageTime,
    stageDepth,
    stageForce,
    stagePower,
    // of a zone or section
    compliance,
    deviationLeast,
    deviationMost,
    deviationMean,
    radialRunout,
    roundness,
    roughness,
    placeForce,
    // of a double stroke or revolution, or of one of its steps, in a zone or section
    programmedFeed,
    actualFeed,
    lag,
    accumulatedFeed,
    stockLeft,
    force,
    runoutAfter,
    damagedLayer,
    burnLimit,
    // of the batch, and of the mean diameter of a zone or section over it
    batchBad,
    batchMean,
    batchDeviation,
    batchMeanHalf,
    batchPp,
    batchPpk,
    // of the search
    bestTime,
    levelsBestTime,
    levelsRuleTime,
    levelsRuleGap,
    count_
};

/// What a figure is of.
enum class FigureScope { cycle, stage, place, step, batch, batchPlace, search };

/// A figure as a lesson asks for it. What its scope does not need is not given.
struct Figure {
    FigureName name = FigureName::cycleTime;
    PlaceName place;
    std::optional<int> stage; ///< from 1
    std::optional<int> count; ///< double stroke or revolution from 1; not given: the last one
    Step step = Step::none;   ///< none: of the whole double stroke or revolution
    friend bool operator==(const Figure&, const Figure&) = default;
};

/// What is said of a figure wherever it is named.
struct FigureRow {
    FigureName name;
    Choice choice; ///< its key in files, and its label
    const char* unit;
    int digits; ///< decimals that can be read
    FigureScope scope;
    bool ofSurface; ///< known of the cut part alone where strips stay uncut
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
