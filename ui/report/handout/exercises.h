// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/handout/handout_step.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

/// Questions to students that the numbers of a project answer: one input is changed, and the engine
/// runs the changed project for the answer.
namespace sparkout::report {

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

struct Answer {
    Asked asked;
    double before = 0;
    double after = 0;
};

struct Exercise {
    QString question;
    QString reason; ///< how each answer moves, and why
    Project changed;
    std::optional<Place> at{}; ///< the step that is asked for, in both runs
    std::vector<Answer> answers{};
};

inline constexpr std::size_t mostExercises = 5;

/// At most five, each of one input changed. Left out are a change that the inputs do not allow,
/// one with which the cycle does not reach size, and what it does not move far enough to be read.
/// `step` is of the outcome's trajectory, if that was recorded.
[[nodiscard]] std::vector<Exercise> makeExercises(
    const Outcome& outcome, const std::optional<HandoutStep>& step,
    const std::function<void()>& breathe = [] {});

[[nodiscard]] QString askedQuantity(Asked asked, Operation operation);
[[nodiscard]] QString askedName(Asked asked, Operation operation); ///< with its unit
[[nodiscard]] QString askedNumber(Asked asked, double value);
/// Whether the two differ by enough to be read off the run, and off a gauge in the shop.
[[nodiscard]] bool canBeRead(const Answer& answer);
/// "Machining time rises".
[[nodiscard]] QString movedText(Asked asked, Operation operation, bool rises);

/// What is asked for in a result; nothing for a step when there is no visit.
[[nodiscard]] std::optional<double> askedValue(Asked asked, const SimulationResult& result,
                                               const Visit* visit);

} // namespace sparkout::report
