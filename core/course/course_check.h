// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"
#include "core/lesson/goal_check.h"
#include "core/lesson/lesson.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// The results of checking an answer to each step of a lesson.
struct CheckedSteps {
    Lesson lesson;
    std::vector<GoalResult> steps;
};

/// Checks each step as given, before the student changes anything. If the lesson asks for the best
/// cycle, its time is searched first.
[[nodiscard]] CheckedSteps checkedAsGiven(Lesson lesson, const std::stop_token& stop = {});

/// The last answers of a work, checked by the engine.
[[nodiscard]] CheckedSteps checkedAnswers(const Work& work);

} // namespace sparkout
