// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/lesson.h"

namespace sparkout {

/// Which texts a lesson must have right: of a student's file no option is.
enum class LessonOf { teacher, student };

/// Faults of a lesson beside those of its keys, ranges and project: paths that name no input of the
/// project, figures and moments that it does not have, goals that are none or several, prices above
/// the points.
[[nodiscard]] Issues checkLesson(const Lesson& lesson, LessonOf of = LessonOf::teacher);

} // namespace sparkout
