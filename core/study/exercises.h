// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "core/study/recorded_step.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// Exercises for students that the numbers of a project answer: one input is changed, and the
/// engine runs the changed project for the answer. Here are the numbers; the words are the
/// window's.
namespace sparkout {

/// What is asked for.
enum class Asked {
    stepFeed_um,  ///< a of the chosen step
    stepForce_n,  ///< P_y there
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

/// The input that is changed, and by how much.
enum class ExerciseChange {
    dullerWheel,  ///< dullness
    softerSystem, ///< every compliance, given or computed, by the same factor
    slowerFeed,   ///< of the last stage that feeds
    moreRunout,   ///< of the blank
    thickerStock, ///< for the first stage to take off
};
inline constexpr double dullerBy = 2, softerBy = 1.5, slowerBy = 0.5, moreRunoutBy = 2,
                        thickerBy = 1.2;

/// An exercise that was run.
struct ExerciseRun {
    ExerciseChange change = ExerciseChange::dullerWheel;
    Project changed{};
    std::size_t stage = 0;                 ///< whose feed is slower
    std::optional<Place> at{};             ///< the step that is asked for, in both runs
    std::vector<ExerciseAnswer> answers{}; ///< what can be read
    std::vector<double> timeByStage_s{};   ///< of the changed project
};

inline constexpr std::size_t mostExercises = 5;

/// At most five, each of one input changed. Left out are a change that the inputs do not allow,
/// one with which the cycle does not reach size, and what it does not move far enough to be read.
/// `step` is of the outcome's trajectory, if that was recorded; `breathe` is called before each
/// run.
[[nodiscard]] std::vector<ExerciseRun> runExercises(
    const Outcome& outcome, const std::optional<RecordedStep>& step,
    const std::function<void()>& breathe = [] {});

/// Whether the two differ by enough to be read off the run, and off a gauge in the shop.
[[nodiscard]] bool canBeRead(const ExerciseAnswer& answer);

/// What is asked for in a result; nothing for a step when there is no visit.
[[nodiscard]] std::optional<double> askedValue(Asked asked, const SimulationResult& result,
                                               const Visit* visit);

} // namespace sparkout
