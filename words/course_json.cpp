// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/course_json.h"

#include "core/course/work.h"
#include "words/lesson_words.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json stepJson(const Lesson& lesson, std::size_t step, const GoalResult& result) {
    const auto orNull = [](const std::optional<double>& value) {
        return value ? ordered_json(*value) : ordered_json(nullptr);
    };
    ordered_json failing = ordered_json::array();
    for (const ConstraintKind kind : result.failing) {
        failing.push_back(requirementOf(kind).key);
    }
    return {{"step", step + 1},
            {"goal", goalKey(lesson.steps[step].goal.kind())},
            {"points", lesson.steps[step].points},
            {"finding", findingKey(result.finding)},
            {"value", orNull(result.value)},
            {"asked", orNull(result.asked)},
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

} // namespace sparkout
