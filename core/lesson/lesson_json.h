// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson_file.h"

#include <nlohmann/json_fwd.hpp>

/// A lesson as a parsed JSON object with its "format" and "version", which a work contains, too.
namespace sparkout {

/// Appends to the issues `found` by parsing.
[[nodiscard]] ReadLesson readLessonJson(const nlohmann::json& root, LessonOf of, Issues found,
                                        const std::stop_token& stop);

[[nodiscard]] nlohmann::ordered_json lessonJson(const Lesson& lesson);

} // namespace sparkout
