// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_file.h"

#include "core/format/strict_json.h"
#include "core/lesson/lesson_json.h"

#include <utility>

namespace sparkout {

ReadLesson readLesson(std::string_view text, LessonOf of, const std::stop_token& stop) {
    Issues issues;
    const auto root = parseStrictly(text, issues, stop);
    if (!root || stop.stop_requested()) {
        return {std::nullopt, stop.stop_requested() ? Issues() : std::move(issues)};
    }
    return readLessonJson(*root, of, std::move(issues), stop);
}

ReadLesson readLessonOfAnybody(std::string_view text) {
    ReadLesson read = readLesson(text);
    if (!read.lesson) {
        if (ReadLesson students = readLesson(text, LessonOf::student); students.lesson) {
            return students;
        }
    }
    return read;
}

std::string writeLesson(const Lesson& lesson) {
    return printJson(lessonJson(lesson));
}

} // namespace sparkout
