// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/lesson_words.h"

#include "core/digits.h"
#include "core/file/output_json.h"
#include "core/lesson/work.h"
#include "core/project/validate.h"
#include "core/text.h"
#include "words/goal_words.h"
#include "words/issue_words.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json stepJson(const Lesson& lesson, std::size_t step, const GoalResult& result) {
    ordered_json failing = ordered_json::array();
    for (const ConstraintKind kind : result.failing) {
        failing.push_back(requirementOf(kind).key);
    }
    return {{"step", step + 1},
            {"goal", goalKey(lesson.steps[step].goal.kind())},
            {"points", lesson.steps[step].points},
            {"finding", findingKey(result.finding)},
            {"value", jsonOrNull(result.value)},
            {"asked", jsonOrNull(result.asked)},
            {"failing", std::move(failing)}};
}

std::string withSteps(ordered_json root, const CheckedSteps& checked) {
    ordered_json& steps = root["steps"] = ordered_json::array();
    for (std::size_t i = 0; i < checked.steps.size(); ++i) {
        steps.push_back(stepJson(checked.lesson, i, checked.steps[i]));
    }
    return root.dump(2) + '\n';
}

} // namespace

std::string lessonCheckJson(const CheckedSteps& checked) {
    return withSteps({{"lesson", checked.lesson.title.in(false)}}, checked);
}

std::string workCheckJson(const Work& work, const CheckedSteps& checked) {
    return withSteps({{"name", work.name},
                      {"group", work.group},
                      {"variant", work.variant},
                      {"sealed", !brokenSeal(work)}},
                     checked);
}

namespace {

std::string leafText(const Leaf& leaf) {
    const Field& field = *leaf.field;
    switch (field.kind) {
    case Kind::number: return numberText(field.as<double>(leaf.owner));
    case Kind::integer: return std::to_string(field.as<int>(leaf.owner));
    case Kind::boolean: return field.as<bool>(leaf.owner) ? "true" : "false";
    case Kind::choice:
        return field.choices[static_cast<std::size_t>(field.getChoice(leaf.owner))].key;
    case Kind::objectList: return std::to_string(field.size(leaf.owner)) + " items";
    default: return "other values";
    }
}

} // namespace

const char* flagText(WorkFlag flag) {
    switch (flag) {
    case WorkFlag::unreadable: return SPARKOUT_NOOP("Grading", "cannot be read");
    case WorkFlag::foreign:
        return SPARKOUT_NOOP("Grading", "of another lesson, or another version of it");
    case WorkFlag::edited: return SPARKOUT_NOOP("Grading", "edited outside the program");
    case WorkFlag::copied:
        return SPARKOUT_NOOP("Grading", "identical to the work of another student");
    case WorkFlag::handedInTwice: return SPARKOUT_NOOP("Grading", "handed in more than once");
    case WorkFlag::notInGroup: return SPARKOUT_NOOP("Grading", "not on the list");
    case WorkFlag::untrueRuns:
        return SPARKOUT_NOOP("Grading", "kept runs whose numbers are not the engine's");
    case WorkFlag::late: return SPARKOUT_NOOP("Grading", "a prediction after the run");
    case WorkFlag::forbidden: return SPARKOUT_NOOP("Grading", "locked inputs changed");
    case WorkFlag::missing: return SPARKOUT_NOOP("Grading", "nothing handed in");
    case WorkFlag::overBudget:
        return SPARKOUT_NOOP("Grading", "took too long: not all of it was checked");
    }
    return "";
}

const char* variantFaultText(VariantFault fault) {
    switch (fault) {
    case VariantFault::alike:
        return SPARKOUT_NOOP("Variants", "another variant has the same inputs");
    case VariantFault::invalid:
        return SPARKOUT_NOOP("Variants", "the project has errors, or its cycle does not end");
    case VariantFault::noFigure:
        return SPARKOUT_NOOP("Variants", "the run does not give a quantity that a step asks for");
    case VariantFault::solved: return SPARKOUT_NOOP("Variants", "a step is solved as given");
    case VariantFault::otherFigure:
        return SPARKOUT_NOOP("Variants", "a figure is outside the bounds that the lesson sets");
    case VariantFault::noAnswer:
        return SPARKOUT_NOOP("Variants", "no cycle of the grid meets the goal");
    case VariantFault::notFree:
        return SPARKOUT_NOOP("Variants", "the best answer changes locked inputs");
    case VariantFault::unattained:
        return SPARKOUT_NOOP("Variants",
                             "no value of a free input was found that gives the required quantity");
    case VariantFault::tooQuick:
        return SPARKOUT_NOOP("Variants", "the best answer is too quick compared with the lesson's");
    case VariantFault::tooSlow:
        return SPARKOUT_NOOP("Variants", "the best answer is too slow compared with the lesson's");
    case VariantFault::otherMargin:
        return SPARKOUT_NOOP("Variants", "the best answer's margin is too far from the lesson's");
    case VariantFault::count_: break;
    }
    return "";
}

const char* lessonFaultText(LessonFault fault) {
    switch (fault) {
    case LessonFault::none: break;
    case LessonFault::noGrid:
        return SPARKOUT_NOOP("Variants", "a step asks for requirements or a time, and the project "
                                         "has no optimisation whose search could prove an answer");
    case LessonFault::noReference:
        return SPARKOUT_NOOP("Variants", "no cycle of the grid of the lesson's own project meets "
                                         "every requirement");
    }
    return "";
}

const char* groupFaultText(GroupFault::Kind kind) {
    switch (kind) {
    case GroupFault::Kind::noName: return SPARKOUT_NOOP("Grading", "the name is missing");
    case GroupFault::Kind::twice: return SPARKOUT_NOOP("Grading", "this student is listed twice");
    case GroupFault::Kind::tooMany: return SPARKOUT_NOOP("Grading", "there are more than 1000");
    case GroupFault::Kind::empty: return SPARKOUT_NOOP("Grading", "there are no students");
    case GroupFault::Kind::moreCells:
        return SPARKOUT_NOOP("Grading", "there are more cells than headings; a name with a comma "
                                        "stands in quotation marks");
    }
    return "";
}

std::string keptRunSentence(const KeptRunCheck& check) {
    if (!check.issues.empty()) {
        return "its inputs cannot be run: " + check.issues.front().path + ": "
               + issueSentence(check.issues.front());
    }
    if (!check.isReadable) {
        return "it contains no readable numbers";
    }
    constexpr std::size_t listed = 3;
    std::string text = std::to_string(check.changed.size())
                       + (check.changed.size() == 1 ? " number is" : " numbers are")
                       + " not the engine's";
    for (std::size_t i = 0; i < check.changed.size() && i < listed; ++i) {
        const ChangedValue& change = check.changed[i];
        text += (i == 0 ? ": " : "; ") + change.path + ' ' + leafText(change.kept)
                + ", by the engine " + (change.now ? leafText(*change.now) : std::string("none"));
    }
    return text + (check.changed.size() > listed ? "; …" : "");
}

} // namespace sparkout
