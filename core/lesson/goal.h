// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/figure.h"

#include <optional>
#include <string>
#include <vector>

/// The goals of a lesson's steps. A kind of goal is a struct with its table; a goal contains
/// exactly one of them.

namespace sparkout {

/// A text in both languages of the program; if only one is given, both are the same.
struct Bilingual {
    std::string ru, en;

    [[nodiscard]] bool empty() const { return ru.empty() && en.empty(); }
    [[nodiscard]] const std::string& in(bool russian) const {
        return (russian ? ru : en).empty() ? (russian ? en : ru) : (russian ? ru : en);
    }
    friend bool operator==(const Bilingual&, const Bilingual&) = default;
};

template <>
const StructInfo& tableOf<Bilingual>();

/// The cycle must end by itself and meet every requirement of the drawing and the machine.
struct RequirementsGoal {
    double least_margin_percent = 0; ///< least margin of the worst requirement
    bool every_stock = false; ///< for any stock within one infeed, where that can be decided;
                              ///< otherwise for the part run
};

/// The cycle is quick enough.
struct TimeGoal {
    std::optional<double> below_min; ///< [min]
    /// Limit relative to the proved best cycle of the project's grid; converted into `below_min` of
    /// each variant.
    std::optional<double> within_percent_of_best;
    bool requirements_hold = true; ///< the requirements must be met, too
};

/// A figure of the run must have a value.
struct FigureGoal {
    Figure figure;
    double value = 0;     ///< in the figure's unit
    double tolerance = 0; ///< allowed deviation, ±
};

/// A number predicted before the run, or read off it; the engine computes the right one.
struct NumberPrediction {
    Figure figure;
    double tolerance = 0;         ///< ±, in the figure's unit
    double tolerance_percent = 0; ///< ±, in per cent; the greater one applies
    bool after_run = false;       ///< answered after the run, by reading or computing
};

/// The abscissa of a predicted curve.
enum class CurveAlong { count, stage, place };

/// A curve predicted before the run, by points joined by straight lines.
struct CurvePrediction {
    Figure figure;
    CurveAlong along = CurveAlong::count;
    std::vector<double> at; ///< places of comparison
    double tolerance = 0;
    double tolerance_percent = 0;
    double least_share_percent = 100; ///< share of the places that must be within the tolerance
};

/// The zones or sections in the order of a figure, the largest first, predicted before the run.
struct OrderPrediction {
    Figure figure;
    double alike = 0; ///< values no further apart may be in either order
};

struct ChoiceOption {
    Bilingual text;
    bool right = false;
};

/// One or several options are right.
struct ChoiceGoal {
    std::vector<ChoiceOption> options;
};

/// An answer in words, read by the teacher.
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

    [[nodiscard]] int count() const;     ///< of the given kinds; 1 if read from a file
    [[nodiscard]] GoalKind kind() const; ///< the first kind that is given
    /// The requested figure; null if there is none.
    [[nodiscard]] const Figure* asked() const;
};

[[nodiscard]] const char* goalKey(GoalKind kind);

/// Whether the answer is given before the run.
[[nodiscard]] bool isPrediction(const Goal& goal);
/// Whether the engine computes the answer, given before the run or after it.
[[nodiscard]] constexpr bool isAnsweredByEngine(GoalKind kind) {
    return kind == GoalKind::prediction || kind == GoalKind::curve || kind == GoalKind::order;
}
/// Whether it is met by settings of the student.
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

/// A student's answer to a step; members that its goal does not ask for are not given.
struct Answer {
    JsonText setup; ///< set-up as the text of a project file; {}: unchanged from the beginning of
                    ///< the step
    std::optional<double> number;              ///< predicted
    NumberRows curve;                          ///< predicted, points [x, y] with rising x
    std::optional<std::vector<double>> order;  ///< places counted from 0, the largest first
    std::optional<std::vector<double>> chosen; ///< options, from 1
    std::string text;

    /// Whether a set-up was handed in.
    [[nodiscard]] bool hasSetup() const { return setup != JsonText(); }
    friend bool operator==(const Answer&, const Answer&) = default;
};

template <>
const StructInfo& tableOf<Answer>();

} // namespace sparkout
