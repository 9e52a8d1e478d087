// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/goal.h"

#include "core/project/conditions.h"

#include <array>

namespace sparkout {

namespace {

constexpr double largest = 1e9;

/// Whether each kind is given, in the order of GoalKind.
std::array<bool, 8> given(const Goal& goal) {
    return {goal.requirements.has_value(), goal.time.has_value(),  goal.figure.has_value(),
            goal.prediction.has_value(),   goal.curve.has_value(), goal.order.has_value(),
            goal.choice.has_value(),       goal.text.has_value()};
}

} // namespace

int Goal::count() const {
    int count = 0;
    for (const bool each : given(*this)) {
        count += each ? 1 : 0;
    }
    return count;
}

GoalKind Goal::kind() const {
    const auto all = given(*this);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i]) {
            return static_cast<GoalKind>(i);
        }
    }
    return GoalKind::text;
}

const Figure* Goal::asked() const {
    return figure       ? &figure->figure
           : prediction ? &prediction->figure
           : curve      ? &curve->figure
           : order      ? &order->figure
                        : nullptr;
}

bool isPrediction(const Goal& goal) {
    return isAnsweredByEngine(goal.kind()) && !(goal.prediction && goal.prediction->after_run);
}

const char* goalKey(GoalKind kind) {
    return tableOf<Goal>().fields[static_cast<std::size_t>(kind)].key;
}

template <>
std::span<const Choice> choicesOf<CurveAlong>() {
    static constexpr std::array choices{Choice{"count", "double strokes or revolutions"},
                                        Choice{"stage", "stages"},
                                        Choice{"place", "zones or sections"}};
    return choices;
}

template <>
const StructInfo& tableOf<RequirementsGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(RequirementsGoal, least_margin_percent, .label = "Least margin", .unit = "%",
                       .hard = {0, 100},
                       .hint = "The relative margin that the worst requirement is to have left."),
    };
    static const StructInfo info = makeTable<RequirementsGoal>("Requirements hold", rows);
    return info;
}

template <>
const StructInfo& tableOf<TimeGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(TimeGoal, below_min, .label = "Below", .unit = "min",
                       .hard = {0, 100000, true},
                       .nullMeaning = "it follows from the proved best of each variant"),
        SPARKOUT_FIELD(TimeGoal, within_percent_of_best, .label = "Within so much of the best",
                       .unit = "%", .hard = {0, 1000}, .nullMeaning = "a time is given",
                       .hint = "Of the quickest cycle of the project's grid that holds every "
                               "requirement, as the search proves it for each variant."),
        SPARKOUT_FIELD(TimeGoal, requirements_hold, .label = "Every requirement holds as well"),
    };
    static const StructInfo info = makeTable<TimeGoal>("Quick enough", rows);
    return info;
}

template <>
const StructInfo& tableOf<FigureGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(FigureGoal, figure, .label = "Figure"),
        SPARKOUT_FIELD(FigureGoal, value, .label = "Value", .hard = {-largest, largest},
                       .required = conditions::always, .hint = "In the unit of the figure."),
        SPARKOUT_FIELD(FigureGoal, tolerance, .label = "Tolerance", .hard = {0, largest, true},
                       .required = conditions::always, .hint = "Either way."),
    };
    static const StructInfo info = makeTable<FigureGoal>("Figure has a value", rows);
    return info;
}

template <>
const StructInfo& tableOf<NumberPrediction>() {
    static const std::array rows{
        SPARKOUT_FIELD(NumberPrediction, figure, .label = "Figure"),
        SPARKOUT_FIELD(NumberPrediction, tolerance, .label = "Tolerance", .hard = {0, largest},
                       .hint = "Either way, in the unit of the figure."),
        SPARKOUT_FIELD(NumberPrediction, tolerance_percent, .label = "Tolerance, relative",
                       .unit = "%", .hard = {0, 100},
                       .hint = "Of the engine's value. The greater of both tolerances holds."),
        SPARKOUT_FIELD(NumberPrediction, after_run, .label = "Read off the run", .sparse = true,
                       .hint = "Else it is said before the run, and nothing is shown until then."),
    };
    static const StructInfo info = makeTable<NumberPrediction>("Number predicted", rows);
    return info;
}

template <>
const StructInfo& tableOf<CurvePrediction>() {
    static const std::array rows{
        SPARKOUT_FIELD(CurvePrediction, figure, .label = "Figure"),
        SPARKOUT_FIELD(CurvePrediction, along, .label = "Along"),
        SPARKOUT_FIELD(CurvePrediction, at, .label = "At", .hard = {0, 10000000},
                       .required = conditions::always, .whole = true,
                       .hint = "Where the drawn curve is compared: double strokes, revolutions and "
                               "stages from 1, sections from 0, zones as 0, 1, 2."),
        SPARKOUT_FIELD(CurvePrediction, tolerance, .label = "Tolerance", .hard = {0, largest},
                       .hint = "Either way, in the unit of the figure."),
        SPARKOUT_FIELD(CurvePrediction, tolerance_percent, .label = "Tolerance, relative",
                       .unit = "%", .hard = {0, 100},
                       .hint = "Of the engine's value. The greater of both tolerances holds."),
        SPARKOUT_FIELD(CurvePrediction, least_share_percent, .label = "Share within it",
                       .unit = "%", .hard = {1, 100},
                       .hint = "Of the places where it is compared."),
    };
    static const StructInfo info = makeTable<CurvePrediction>("Curve predicted", rows);
    return info;
}

template <>
const StructInfo& tableOf<OrderPrediction>() {
    static const std::array rows{
        SPARKOUT_FIELD(OrderPrediction, figure, .label = "Figure"),
        SPARKOUT_FIELD(OrderPrediction, alike, .label = "Alike within", .hard = {0, largest},
                       .hint = "Places whose values are no further apart may stand in either "
                               "order."),
    };
    static const StructInfo info = makeTable<OrderPrediction>("Order predicted", rows);
    return info;
}

template <>
const StructInfo& tableOf<ChoiceOption>() {
    static const std::array rows{
        SPARKOUT_FIELD(ChoiceOption, text, .label = "Text"),
        SPARKOUT_FIELD(ChoiceOption, right, .label = "Right", .sparse = true),
    };
    static const StructInfo info = makeTable<ChoiceOption>("Option", rows);
    return info;
}

template <>
const StructInfo& tableOf<ChoiceGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(ChoiceGoal, options, .label = "Options", .hard = {2, 20},
                       .required = conditions::always,
                       .hint = "A student's file does not say which of them are right."),
    };
    static const StructInfo info = makeTable<ChoiceGoal>("Right ones chosen", rows);
    return info;
}

template <>
const StructInfo& tableOf<TextGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(TextGoal, least_letters, .label = "Least length", .hard = {1, 10000},
                       .hint = "Letters that an answer is to have."),
    };
    static const StructInfo info = makeTable<TextGoal>("Answer in words", rows);
    return info;
}

template <>
const StructInfo& tableOf<Goal>() {
    static const std::array rows{
        SPARKOUT_FIELD(Goal, requirements, .label = "Requirements hold", .nullMeaning = "not asked",
                       .hint = "The cycle ends by itself and every requirement holds."),
        SPARKOUT_FIELD(Goal, time, .label = "Quick enough", .nullMeaning = "not asked",
                       .hint = "The cycle takes less than a time."),
        SPARKOUT_FIELD(Goal, figure, .label = "Figure", .nullMeaning = "not asked",
                       .hint = "A figure of the run has a value, within a tolerance."),
        SPARKOUT_FIELD(Goal, prediction, .label = "Number predicted", .nullMeaning = "not asked",
                       .hint = "A figure is said before the run."),
        SPARKOUT_FIELD(Goal, curve, .label = "Curve predicted", .nullMeaning = "not asked",
                       .hint = "A curve is drawn before the run."),
        SPARKOUT_FIELD(Goal, order, .label = "Order predicted", .nullMeaning = "not asked",
                       .hint = "Zones or sections are put in order before the run."),
        SPARKOUT_FIELD(Goal, choice, .label = "Choice", .nullMeaning = "not asked",
                       .hint = "All right options are chosen and no other."),
        SPARKOUT_FIELD(Goal, text, .label = "Answer in words", .nullMeaning = "not asked",
                       .hint = "It is kept for the teacher, who gives the points."),
    };
    static const StructInfo info = makeTable<Goal>("Goal", rows);
    return info;
}

} // namespace sparkout
