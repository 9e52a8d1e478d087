// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/lesson.h"

namespace sparkout {

/// The owner of a lesson; a student's file need not contain the right options.
enum class LessonOf { teacher, student };

/// Faults of a lesson in addition to those of its keys, ranges and project: paths without an input,
/// figures and moments that the project does not have, a missing or ambiguous goal, prices above
/// the points.
[[nodiscard]] Issues checkLesson(const Lesson& lesson, LessonOf of = LessonOf::teacher);

} // namespace sparkout
