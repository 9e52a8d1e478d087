// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/lesson.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// The lesson file, `.sparkout-lesson`: one UTF-8 JSON text, read and written by the tables, its
/// project as in a project file of either version.
namespace sparkout {

/// The owner of a lesson; a student's file need not contain the right options.
enum class LessonOf { teacher, student };

/// Faults of a lesson in addition to those of its keys, ranges and project: paths without an input,
/// figures and moments that the project does not have, a missing or ambiguous goal, prices above
/// the points.
[[nodiscard]] Issues checkLesson(const Lesson& lesson, LessonOf of = LessonOf::teacher);

inline constexpr const char* lessonFormat = "sparkout-lesson";
inline constexpr int lessonVersion = 1;

struct ReadLesson {
    std::optional<Lesson> lesson; ///< given without errors
    Issues issues;                ///< errors, or warnings with a lesson
};

/// Reads and checks a lesson within the limits of a project file (project_file.h). Returns all
/// faults at once, those of its project below "/project".
[[nodiscard]] ReadLesson readLesson(std::string_view text, LessonOf of = LessonOf::teacher,
                                    const std::stop_token& stop = {});

/// Reads a teacher's or a student's lesson. The faults are those of a teacher's.
[[nodiscard]] ReadLesson readLessonOfAnybody(std::string_view text);

/// The text of a lesson: the same lesson, the same bytes.
[[nodiscard]] std::string writeLesson(const Lesson& lesson);

} // namespace sparkout
