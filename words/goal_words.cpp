// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/goal_words.h"

#include "core/digits.h"
#include "core/project/validate.h"
#include "core/text.h"
#include "words/issue_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace sparkout {

namespace {

constexpr std::array<const char*, findings> findingKeys{
    "passed",    "failed",  "not_answered", "for_teacher",
    "forbidden", "refused", "does_not_end", "no_such_figure"};

constexpr const char* everyRequirement = SPARKOUT_NOOP("Goal", "Every requirement must be met.");

std::string joinedParts(const std::vector<std::string>& parts, std::string_view between) {
    std::string text;
    for (const std::string& part : parts) {
        if (!part.empty()) {
            text += (text.empty() ? std::string() : std::string(between)) + part;
        }
    }
    return text;
}

} // namespace

const char* findingKey(Finding finding) {
    return findingKeys[static_cast<std::size_t>(finding)];
}

const char* findingText(Finding finding) {
    switch (finding) {
    case Finding::passed: return SPARKOUT_NOOP("Finding", "passed");
    case Finding::failed: return SPARKOUT_NOOP("Finding", "not passed");
    case Finding::notAnswered: return SPARKOUT_NOOP("Finding", "not answered");
    case Finding::forTeacher: return SPARKOUT_NOOP("Finding", "for the teacher to mark");
    case Finding::forbidden: return SPARKOUT_NOOP("Finding", "locked inputs were changed");
    case Finding::refused: return SPARKOUT_NOOP("Finding", "the inputs have errors");
    case Finding::doesNotEnd: return SPARKOUT_NOOP("Finding", "the cycle does not end by itself");
    case Finding::noSuchFigure:
        return SPARKOUT_NOOP("Finding", "the run does not give this quantity");
    }
    return "";
}

std::string GoalWording::translated(const char*, const char* text) const {
    return text;
}

std::string GoalWording::number(double value) const {
    return numberText(value);
}

std::string GoalWording::fixed(double value, int decimals) const {
    return sparkout::fixed(value, decimals);
}

std::string GoalWording::withUnit(const std::string& number, const char* unit) const {
    return *unit ? number + ' ' + unit : number;
}

std::string GoalWording::inSentence(const std::string& name) const {
    std::string text = name;
    if (text.starts_with("Pp")) { // Pp and Ppk, symbols
        return text;
    }
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return text;
}

std::string GoalWording::zoneOrSection(const Project& project, std::size_t index) const {
    const PlaceName place = placeName(project, index);
    return place.zone ? PlaceName::words()[place.index()].key
                      : "section " + std::to_string(index + 1);
}

std::string GoalWording::step(Step step) const {
    return choicesOf<Step>()[static_cast<std::size_t>(step)].key;
}

std::string GoalWording::input(const std::string& path) const {
    return path;
}

std::string GoalWording::fault(const Issue& issue) const {
    return issue.path + ": " + issueSentence(issue);
}

std::string GoalWording::filled(const char* text, TextPlaces places) const {
    return placedText(translated("Goal", text), places);
}

std::string GoalWording::quantity(const Figure& figure, const Project& project) const {
    const auto counted = [this](const char* text, int number) {
        return filled(text, {{"number", std::to_string(number)}});
    };
    std::vector<std::string> parts{translated("Figure", rowOf(figure.name).choice.label)};
    if (figure.place.isGiven()) {
        parts.push_back(zoneOrSection(project, figure.place.index()));
    }
    if (figure.stage) {
        parts.push_back(counted(SPARKOUT_NOOP("Goal", "stage {number}"), *figure.stage));
    }
    if (figure.count) {
        parts.push_back(counted(project.operation->travels
                                    ? SPARKOUT_NOOP("Goal", "double stroke {number}")
                                    : SPARKOUT_NOOP("Goal", "revolution {number}"),
                                *figure.count));
    }
    if (figure.step != Step::none) {
        parts.push_back(step(figure.step));
    }
    return joinedParts(parts, ", ");
}

std::string GoalWording::value(const Figure& figure, double value) const {
    const FigureRow& row = rowOf(figure.name);
    return withUnit(fixed(value, row.digits), row.unit);
}

std::string GoalWording::tolerance(const Figure& figure, double tolerance) const {
    const FigureRow& row = rowOf(figure.name);
    return withUnit(fixed(tolerance, row.digits + 1), row.unit);
}

std::string GoalWording::order(const Project& project,
                               const std::vector<std::size_t>& places) const {
    std::vector<std::string> names;
    for (const std::size_t place : places) {
        names.push_back(zoneOrSection(project, place));
    }
    return joinedParts(names, " > ");
}

std::string GoalWording::asked(const Goal& goal, const Project& project) const {
    const auto ofQuantity = [&](const char* text, const Figure& figure) {
        const char* const unit = rowOf(figure.name).unit;
        const std::string name = inSentence(quantity(figure, project));
        return filled(text, {{"quantity", *unit ? withUnit(name + ',', unit) : name}});
    };
    switch (goal.kind()) {
    case GoalKind::requirements: {
        const double margin = goal.requirements->least_margin_percent;
        const bool every = goal.requirements->every_stock;
        return filled(
            margin > 0
                ? (every ? SPARKOUT_NOOP("Goal", "Every requirement must be met for every stock, "
                                                 "with a margin of at least {margin} %.")
                         : SPARKOUT_NOOP("Goal", "Every requirement must be met, with a margin of "
                                                 "at least {margin} %."))
            : every ? SPARKOUT_NOOP("Goal", "Every requirement must be met for every stock.")
                    : everyRequirement,
            {{"margin", number(margin)}});
    }
    case GoalKind::time: {
        const TimeGoal& time = *goal.time;
        const std::string limit =
            time.below_min
                ? filled(SPARKOUT_NOOP("Goal", "The cycle must take at most {time} min."),
                         {{"time", number(*time.below_min)}})
            : time.within_percent_of_best
                ? filled(SPARKOUT_NOOP("Goal", "The cycle must take at most {percent} % more than "
                                               "the best one."),
                         {{"percent", number(*time.within_percent_of_best)}})
                : std::string();
        return joinedParts({limit, time.requirements_hold ? filled(everyRequirement, {}) : ""},
                           " ");
    }
    case GoalKind::figure: {
        const FigureGoal& figure = *goal.figure;
        return filled(
            SPARKOUT_NOOP("Goal", "Reach {quantity} = {value} ± {tolerance}."),
            {{"quantity", inSentence(quantity(figure.figure, project))},
             {"value", number(figure.value)},
             {"tolerance", withUnit(number(figure.tolerance), rowOf(figure.figure.name).unit)}});
    }
    case GoalKind::prediction:
        return ofQuantity(goal.prediction->after_run
                              ? SPARKOUT_NOOP("Goal", "Determine from the run: {quantity}.")
                              : SPARKOUT_NOOP("Goal", "Predict before the run: {quantity}."),
                          goal.prediction->figure);
    case GoalKind::curve:
        return ofQuantity(SPARKOUT_NOOP("Goal", "Draw before the run: {quantity}."),
                          goal.curve->figure);
    case GoalKind::order:
        return filled(SPARKOUT_NOOP("Goal",
                                    "Predict before the run the order by {quantity}, the largest "
                                    "first."),
                      {{"quantity", inSentence(quantity(goal.order->figure, project))}});
    case GoalKind::choice:
        return filled(SPARKOUT_NOOP("Goal", "One or several answers are right."), {});
    case GoalKind::text:
        return filled(SPARKOUT_NOOP("Goal", "Answer in words; the teacher marks the answer."), {});
    }
    return {};
}

/// "actual feed, rz1: prediction 3.2 µm, result 3.1 µm, tolerance ± 0.2 µm".
std::string GoalWording::compared(const Goal& goal, const GoalResult& result,
                                  const Project& project) const {
    const Figure& figure = *goal.asked();
    std::vector<std::string> parts;
    if (goal.figure && result.asked) {
        parts.push_back(
            filled(SPARKOUT_NOOP("Goal", "required {value} ± {tolerance}"),
                   {{"value", number(*result.asked)},
                    {"tolerance", withUnit(number(result.tolerance), rowOf(figure.name).unit)}}));
    } else if (goal.prediction && result.asked) {
        parts.push_back(filled(SPARKOUT_NOOP("Goal", "answer {value}"),
                               {{"value", value(figure, *result.asked)}}));
    }
    if (goal.order && !result.order.empty()) {
        parts.push_back(order(project, result.order));
    } else if (!goal.order && result.value) {
        parts.push_back(filled(SPARKOUT_NOOP("Goal", "result {value}"),
                               {{"value", value(figure, *result.value)}}));
    }
    if (goal.prediction && result.value) {
        parts.push_back(filled(SPARKOUT_NOOP("Goal", "tolerance ± {value}"),
                               {{"value", tolerance(figure, result.tolerance)}}));
    }
    const std::string name = inSentence(quantity(figure, project));
    return parts.empty() ? name : name + ": " + joinedParts(parts, ", ");
}

std::vector<std::string> GoalWording::numbers(const Goal& goal, const GoalResult& result,
                                              const Project& project) const {
    constexpr int marginDigits = 1, timeDigits = 3;
    std::vector<std::string> parts;
    switch (goal.kind()) {
    case GoalKind::requirements:
        if (result.value) {
            parts.push_back(filled(SPARKOUT_NOOP("Goal", "minimum margin {margin} %"),
                                   {{"margin", fixed(*result.value, marginDigits)}}));
        }
        break;
    case GoalKind::time:
        if (result.value) {
            const std::string time = fixed(*result.value, timeDigits);
            parts.push_back(
                result.asked
                    ? filled(SPARKOUT_NOOP("Goal", "cycle time {time} min, limit {limit} min"),
                             {{"time", time}, {"limit", fixed(*result.asked, timeDigits)}})
                    : filled(SPARKOUT_NOOP("Goal", "cycle time {time} min"), {{"time", time}}));
        }
        break;
    case GoalKind::figure:
    case GoalKind::prediction:
    case GoalKind::order: parts.push_back(compared(goal, result, project)); break;
    case GoalKind::curve:
        if (!result.curve.empty()) {
            parts.push_back(
                filled(SPARKOUT_NOOP("Goal", "within the tolerance at {share} % of the places, "
                                             "required {least} %"),
                       {{"share", fixed(result.value.value_or(0), 0)},
                        {"least", fixed(goal.curve->least_share_percent, 0)}}));
        }
        break;
    case GoalKind::choice:
    case GoalKind::text: break;
    }
    if (result.failingStocks_percent) {
        parts.push_back(filled(SPARKOUT_NOOP("Goal", "unfit for {share} % of stocks"),
                               {{"share", fixed(*result.failingStocks_percent, 0)}}));
    }
    std::vector<std::string> names;
    for (const ConstraintKind kind : result.failing) {
        names.push_back(inSentence(translated("Requirement", requirementOf(kind).label)));
    }
    if (!names.empty()) {
        parts.push_back(filled(SPARKOUT_NOOP("Goal", "not met: {names}"),
                               {{"names", joinedParts(names, ", ")}}));
    }
    return parts;
}

std::string GoalWording::found(const Goal& goal, const GoalResult& result, const Project& project,
                               bool showsAnswer) const {
    std::vector<std::string> parts;
    if (result.finding != Finding::notAnswered || showsAnswer) {
        parts = numbers(goal, result, project);
    }
    for (const std::string& path : result.forbidden) {
        parts.push_back(input(path));
    }
    const auto error = std::ranges::find(result.issues, Severity::error, &Issue::severity);
    if (error != result.issues.end()) {
        parts.push_back(fault(*error));
    }
    return joinedParts(
        {translated("Finding", findingText(result.finding)), joinedParts(parts, "; ")}, ": ");
}

} // namespace sparkout
