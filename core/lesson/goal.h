// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/bilingual.h"
#include "core/lesson/figure.h"

#include <optional>
#include <vector>

/// What a step of a lesson asks for. A kind of goal is a struct with its table; a goal holds
/// exactly one of them.
namespace sparkout {

/// The cycle ends by itself and meets every requirement of the drawing and the machine.
struct RequirementsGoal {
    double least_margin_percent = 0; ///< that the worst requirement is to have left
    bool every_stock = false; ///< within one infeed, where that can be decided; else the part run
};

/// The cycle is quick enough.
struct TimeGoal {
    std::optional<double> below_min; ///< [min]
    /// Of the proved best of the project's grid; made into `below_min` of each variant.
    std::optional<double> within_percent_of_best;
    bool requirements_hold = true; ///< as well
};

/// A figure of the run has a value.
struct FigureGoal {
    Figure figure;
    double value = 0;     ///< in the figure's unit
    double tolerance = 0; ///< either way
};

/// A number said before the run, or read off it; the engine has the right one.
struct NumberPrediction {
    Figure figure;
    double tolerance = 0;         ///< either way, in the figure's unit
    double tolerance_percent = 0; ///< the same, of the engine's value; the greater holds
    bool after_run = false;       ///< read off the run, or computed from what is
};

/// What a predicted curve runs along.
enum class CurveAlong { count, stage, place };

/// A curve said before the run, by points that are joined by straight lines.
struct CurvePrediction {
    Figure figure;
    CurveAlong along = CurveAlong::count;
    std::vector<double> at; ///< where it is compared
    double tolerance = 0;
    double tolerance_percent = 0;
    double least_share_percent = 100; ///< of the places that must be within it
};

/// The zones or sections in the order of a figure, the largest first, said before the run.
struct OrderPrediction {
    Figure figure;
    double alike = 0; ///< values no further apart may stand in either order
};

struct ChoiceOption {
    Bilingual text;
    bool right = false;
};

/// One or several of these are right.
struct ChoiceGoal {
    std::vector<ChoiceOption> options;
};

/// An answer in words, which the teacher reads.
struct TextGoal {
    int least_letters = 1;
};

enum class GoalKind { requirements, time, figure, prediction, curve, order, choice, text };

struct Goal {
    std::optional<RequirementsGoal> requirements;
    std::optional<TimeGoal> time;
    std::optional<FigureGoal> figure;
    std::optional<NumberPrediction> prediction;
    std::optional<CurvePrediction> curve;
    std::optional<OrderPrediction> order;
    std::optional<ChoiceGoal> choice;
    std::optional<TextGoal> text;

    [[nodiscard]] int count() const;     ///< of kinds that are given; of a lesson that was read 1
    [[nodiscard]] GoalKind kind() const; ///< of the first that is given
    /// The figure it asks for; null: none.
    [[nodiscard]] const Figure* asked() const;
};

[[nodiscard]] const char* goalKey(GoalKind kind);

/// Whether the answer is said before the run.
[[nodiscard]] bool isPrediction(const Goal& goal);
/// Whether the engine has the answer, said before the run or after it.
[[nodiscard]] constexpr bool isAnsweredByEngine(GoalKind kind) {
    return kind == GoalKind::prediction || kind == GoalKind::curve || kind == GoalKind::order;
}
/// Whether it is met by what the student sets.
[[nodiscard]] constexpr bool isMetBySetting(GoalKind kind) {
    return kind == GoalKind::requirements || kind == GoalKind::time || kind == GoalKind::figure;
}

template <>
std::span<const Choice> choicesOf<CurveAlong>();
template <>
const StructInfo& tableOf<RequirementsGoal>();
template <>
const StructInfo& tableOf<TimeGoal>();
template <>
const StructInfo& tableOf<FigureGoal>();
template <>
const StructInfo& tableOf<NumberPrediction>();
template <>
const StructInfo& tableOf<CurvePrediction>();
template <>
const StructInfo& tableOf<OrderPrediction>();
template <>
const StructInfo& tableOf<ChoiceOption>();
template <>
const StructInfo& tableOf<ChoiceGoal>();
template <>
const StructInfo& tableOf<TextGoal>();
template <>
const StructInfo& tableOf<Goal>();

} // namespace sparkout
