// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "core/study/outcome.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// Exercises for students on the numbers of a project: one input is changed, and the engine runs
/// the changed project for the answer. This file makes the numbers, the window the texts.
namespace sparkout {

/// A visit of the wheel to one radius in a recorded run.
struct RecordedStep {
    std::size_t pass = 0; ///< index in the trajectory
    int radius = 0;       ///< k
    friend bool operator==(const RecordedStep&, const RecordedStep&) = default;
};

[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const RecordedStep& step);

/// Returns the visit of a radius at a place; null if there is none.
[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const Place& place, int radius);

/// Returns the place nearest to the given one, by double stroke or revolution, at which both runs
/// have this zone, stage, step and revolution; empty if there is none.
[[nodiscard]] std::optional<Place> sharedPlace(const Trajectory& one, const Trajectory& other,
                                               const Place& place);

/// Quantity that an exercise asks for.
enum class Asked {
    stepFeed_um,  ///< a of the chosen step
    stepForce_n,  ///< P_y of that step
    time_min,     ///< machining time
    count,        ///< double strokes or revolutions
    spread_um,    ///< largest less smallest diameter over the part
    runout_um,    ///< largest radial runout of a zone or section
    peakForce_n,  ///< largest P_y of the cycle
    peakPower_kw, ///< largest P_z·V_k of the cycle
};

struct ExerciseAnswer {
    Asked asked;
    double before = 0;
    double after = 0;
};

/// Input that is changed.
enum class ExerciseChange {
    dullerWheel,  ///< dullness
    softerSystem, ///< every compliance, given or computed, by the same factor
    slowerFeed,   ///< feed of the last feeding stage
    moreRunout,   ///< radial runout of the blank
    thickerStock, ///< stock of the first stage
};
inline constexpr double dullerBy = 2, softerBy = 1.5, slowerBy = 0.5, moreRunoutBy = 2,
                        thickerBy = 1.2;

/// An exercise that was run.
struct ExerciseRun {
    ExerciseChange change = ExerciseChange::dullerWheel;
    Project changed{};
    std::size_t stage = 0;                 ///< the stage whose feed is slower
    std::optional<Place> at{};             ///< the step in question, in both runs
    std::vector<ExerciseAnswer> answers{}; ///< answers that can be read off
    std::vector<double> timeByStage_s{};   ///< times of the changed project
};

inline constexpr std::size_t mostExercises = 5;

/// Runs at most mostExercises exercises, each with one input changed. Left out are changes that the
/// inputs do not allow, changes after which the cycle does not reach size, and answers that change
/// too little to be read off. `step` is a step of the outcome's trajectory, if that was recorded;
/// `breathe` is called before each run.
[[nodiscard]] std::vector<ExerciseRun> runExercises(
    const Outcome& outcome, const std::optional<RecordedStep>& step,
    const std::function<void()>& breathe = [] {});

/// Returns whether the two values differ enough to be read off the run, and off a gauge in the
/// shop.
[[nodiscard]] bool canBeRead(const ExerciseAnswer& answer);

/// Returns the quantity in a result; empty if it belongs to a step and the visit is not given.
[[nodiscard]] std::optional<double> askedValue(Asked asked, const SimulationResult& result,
                                               const Visit* visit);

} // namespace sparkout
