// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/goal.h"

#include "core/project/conditions.h"
#include "core/text.h"

#include <array>

namespace sparkout {

template <>
const StructInfo& tableOf<Bilingual>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Bilingual, ru, .label = SPARKOUT_NOOP("Input", "In Russian"), .sparse = true,
            .hint = SPARKOUT_NOOP("Input", "With the tags of the help's pages that fetch nothing; "
                                           "formulas stand in `<p class=\"formula\">`.")),
        SPARKOUT_FIELD(
            Bilingual, en, .label = SPARKOUT_NOOP("Input", "In English"), .sparse = true,
            .hint = SPARKOUT_NOOP("Input", "If one language is missing, the other is shown.")),
    };
    static const StructInfo info =
        makeTable<Bilingual>(SPARKOUT_NOOP("Struct", "Text in both languages"), rows);
    return info;
}

namespace {

constexpr double largestNumber = 1e9;

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
    static constexpr std::array choices{
        Choice{"count", SPARKOUT_NOOP("Choice", "double strokes or revolutions")},
        Choice{"stage", SPARKOUT_NOOP("Choice", "stages")},
        Choice{"place", SPARKOUT_NOOP("Choice", "zones or sections")}};
    return choices;
}

template <>
const StructInfo& tableOf<RequirementsGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            RequirementsGoal, least_margin_percent,
            .label = SPARKOUT_NOOP("Input", "Minimum margin"), .unit = "%", .hard = {0, 100},
            .hint =
                SPARKOUT_NOOP("Input", "Relative margin that the worst requirement must have.")),
        SPARKOUT_FIELD(
            RequirementsGoal, every_stock, .label = SPARKOUT_NOOP("Input", "For every stock"),
            .sparse = true,
            .hint = SPARKOUT_NOOP("Input", "Under gauge control the requirements must be met for "
                                           "every stock within one infeed of the last stage, as in "
                                           "the verdict; otherwise for the part that is run.")),
    };
    static const StructInfo info =
        makeTable<RequirementsGoal>(SPARKOUT_NOOP("Struct", "Requirements are met"), rows);
    return info;
}

template <>
const StructInfo& tableOf<TimeGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(TimeGoal, below_min, .label = SPARKOUT_NOOP("Input", "Below"), .unit = "min",
                       .hard = {0, 100000, true},
                       .nullMeaning = SPARKOUT_NOOP(
                           "Input", "it follows from the proved best of each variant")),
        SPARKOUT_FIELD(
            TimeGoal, within_percent_of_best,
            .label = SPARKOUT_NOOP("Input", "Maximum excess over the best"), .unit = "%",
            .hard = {0, 1000}, .nullMeaning = SPARKOUT_NOOP("Input", "a time is given"),
            .hint = SPARKOUT_NOOP("Input",
                                  "Relative to the quickest cycle of the project's grid that meets "
                                  "every requirement, proved by the search for each variant.")),
        SPARKOUT_FIELD(TimeGoal, requirements_hold,
                       .label = SPARKOUT_NOOP("Input", "Every requirement must be met too")),
    };
    static const StructInfo info =
        makeTable<TimeGoal>(SPARKOUT_NOOP("Struct", "Quick enough"), rows);
    return info;
}

template <>
const StructInfo& tableOf<FigureGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(FigureGoal, figure, .label = SPARKOUT_NOOP("Input", "Figure")),
        SPARKOUT_FIELD(FigureGoal, value, .label = SPARKOUT_NOOP("Input", "Value"),
                       .hard = {-largestNumber, largestNumber}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "In the unit of the figure.")),
        SPARKOUT_FIELD(FigureGoal, tolerance, .label = SPARKOUT_NOOP("Input", "Tolerance"),
                       .hard = {0, largestNumber, true}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "In both directions (±).")),
    };
    static const StructInfo info =
        makeTable<FigureGoal>(SPARKOUT_NOOP("Struct", "Figure has a value"), rows);
    return info;
}

template <>
const StructInfo& tableOf<NumberPrediction>() {
    static const std::array rows{
        SPARKOUT_FIELD(NumberPrediction, figure, .label = SPARKOUT_NOOP("Input", "Figure")),
        SPARKOUT_FIELD(NumberPrediction, tolerance, .label = SPARKOUT_NOOP("Input", "Tolerance"),
                       .hard = {0, largestNumber},
                       .hint = SPARKOUT_NOOP("Input", "±, in the quantity's unit.")),
        SPARKOUT_FIELD(
            NumberPrediction, tolerance_percent,
            .label = SPARKOUT_NOOP("Input", "Tolerance, relative"), .unit = "%", .hard = {0, 100},
            .hint = SPARKOUT_NOOP(
                "Input",
                "Relative to the engine's value. The larger of the two tolerances applies.")),
        SPARKOUT_FIELD(
            NumberPrediction, after_run, .label = SPARKOUT_NOOP("Input", "Read off the run"),
            .sparse = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Otherwise it is predicted before the run, and nothing is shown until then.")),
    };
    static const StructInfo info =
        makeTable<NumberPrediction>(SPARKOUT_NOOP("Struct", "Number predicted"), rows);
    return info;
}

template <>
const StructInfo& tableOf<CurvePrediction>() {
    static const std::array rows{
        SPARKOUT_FIELD(CurvePrediction, figure, .label = SPARKOUT_NOOP("Input", "Figure")),
        SPARKOUT_FIELD(CurvePrediction, along, .label = SPARKOUT_NOOP("Input", "Along")),
        SPARKOUT_FIELD(CurvePrediction, at, .label = SPARKOUT_NOOP("Input", "At"),
                       .hard = {0, 10000000}, .required = conditions::always, .whole = true,
                       .hint = SPARKOUT_NOOP(
                           "Input",
                           "Places where the drawn curve is compared: double strokes, revolutions "
                           "and stages from 1, sections from 0, zones as 0, 1, 2.")),
        SPARKOUT_FIELD(CurvePrediction, tolerance, .label = SPARKOUT_NOOP("Input", "Tolerance"),
                       .hard = {0, largestNumber},
                       .hint = SPARKOUT_NOOP("Input", "±, in the quantity's unit.")),
        SPARKOUT_FIELD(
            CurvePrediction, tolerance_percent,
            .label = SPARKOUT_NOOP("Input", "Tolerance, relative"), .unit = "%", .hard = {0, 100},
            .hint = SPARKOUT_NOOP(
                "Input",
                "Relative to the engine's value. The larger of the two tolerances applies.")),
        SPARKOUT_FIELD(CurvePrediction, least_share_percent,
                       .label = SPARKOUT_NOOP("Input", "Share within the tolerance"), .unit = "%",
                       .hard = {1, 100},
                       .hint = SPARKOUT_NOOP("Input", "Share of the places where it is compared.")),
    };
    static const StructInfo info =
        makeTable<CurvePrediction>(SPARKOUT_NOOP("Struct", "Curve predicted"), rows);
    return info;
}

template <>
const StructInfo& tableOf<OrderPrediction>() {
    static const std::array rows{
        SPARKOUT_FIELD(OrderPrediction, figure, .label = SPARKOUT_NOOP("Input", "Figure")),
        SPARKOUT_FIELD(
            OrderPrediction, alike, .label = SPARKOUT_NOOP("Input", "Tolerance of the order"),
            .hard = {0, largestNumber},
            .hint = SPARKOUT_NOOP(
                "Input", "Places whose values are no further apart may stand in either order.")),
    };
    static const StructInfo info =
        makeTable<OrderPrediction>(SPARKOUT_NOOP("Struct", "Order predicted"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ChoiceOption>() {
    static const std::array rows{
        SPARKOUT_FIELD(ChoiceOption, text, .label = SPARKOUT_NOOP("Input", "Text")),
        SPARKOUT_FIELD(ChoiceOption, right, .label = SPARKOUT_NOOP("Input", "Right"),
                       .sparse = true),
    };
    static const StructInfo info = makeTable<ChoiceOption>(SPARKOUT_NOOP("Struct", "Option"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ChoiceGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(ChoiceGoal, options, .label = SPARKOUT_NOOP("Input", "Options"),
                       .hard = {2, 20}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP(
                           "Input", "A student's file does not state which options are right.")),
    };
    static const StructInfo info =
        makeTable<ChoiceGoal>(SPARKOUT_NOOP("Struct", "Right options chosen"), rows);
    return info;
}

template <>
const StructInfo& tableOf<TextGoal>() {
    static const std::array rows{
        SPARKOUT_FIELD(TextGoal, least_letters, .label = SPARKOUT_NOOP("Input", "Minimum length"),
                       .hard = {1, 10000},
                       .hint = SPARKOUT_NOOP("Input", "Least number of letters of an answer.")),
    };
    static const StructInfo info =
        makeTable<TextGoal>(SPARKOUT_NOOP("Struct", "Answer in words"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Goal>() {
    static const std::array rows{
        SPARKOUT_FIELD(Goal, requirements, .label = SPARKOUT_NOOP("Input", "Requirements are met"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
                       .hint = SPARKOUT_NOOP(
                           "Input", "The cycle ends by itself and every requirement is met.")),
        SPARKOUT_FIELD(Goal, time, .label = SPARKOUT_NOOP("Input", "Quick enough"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
                       .hint = SPARKOUT_NOOP("Input", "The cycle takes less than a time.")),
        SPARKOUT_FIELD(
            Goal, figure, .label = SPARKOUT_NOOP("Input", "Figure"),
            .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
            .hint = SPARKOUT_NOOP("Input", "A figure of the run has a value, within a tolerance.")),
        SPARKOUT_FIELD(Goal, prediction, .label = SPARKOUT_NOOP("Input", "Number predicted"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
                       .hint = SPARKOUT_NOOP("Input", "A figure is predicted before the run.")),
        SPARKOUT_FIELD(Goal, curve, .label = SPARKOUT_NOOP("Input", "Curve predicted"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
                       .hint = SPARKOUT_NOOP("Input", "A curve is drawn before the run.")),
        SPARKOUT_FIELD(
            Goal, order, .label = SPARKOUT_NOOP("Input", "Order predicted"),
            .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
            .hint = SPARKOUT_NOOP("Input", "Zones or sections are put in order before the run.")),
        SPARKOUT_FIELD(Goal, choice, .label = SPARKOUT_NOOP("Input", "Choice"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
                       .hint =
                           SPARKOUT_NOOP("Input", "All right options are chosen and no other.")),
        SPARKOUT_FIELD(
            Goal, text, .label = SPARKOUT_NOOP("Input", "Answer in words"),
            .nullMeaning = SPARKOUT_NOOP("Input", "not asked"),
            .hint = SPARKOUT_NOOP("Input", "It is kept for the teacher, who gives the points.")),
    };
    static const StructInfo info = makeTable<Goal>(SPARKOUT_NOOP("Struct", "Goal"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Answer>() {
    static const std::array rows{
        SPARKOUT_FIELD(Answer, setup, .label = "Set-up", .sparse = true,
                       .hint = "The project as the student has set it, as in a project file."),
        SPARKOUT_FIELD(Answer, number, .label = "Number", .hard = {-largestNumber, largestNumber},
                       .nullMeaning = "not asked for"),
        SPARKOUT_FIELD(Answer, curve, .label = "Curve", .hard = {-largestNumber, largestNumber},
                       .nullMeaning = "not asked for", .hint = "Rows of x and y, x rising."),
        SPARKOUT_FIELD(Answer, order, .label = "Order", .hard = {0, 100000},
                       .nullMeaning = "not asked for",
                       .hint = "Zones or sections from 0, the largest first."),
        SPARKOUT_FIELD(Answer, chosen, .label = "Options chosen", .hard = {1, 20},
                       .nullMeaning = "not asked for", .hint = "From 1."),
        SPARKOUT_FIELD(Answer, text, .label = "Text", .sparse = true),
    };
    static const StructInfo info = makeTable<Answer>("Answer", rows);
    return info;
}

} // namespace sparkout
