// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/group_list.h"
#include "core/lesson/lesson.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// Reads and checks a lesson; prints each fault on a line.
[[nodiscard]] std::optional<Lesson> loadLesson(const std::string& file);

/// Reads a list of students; prints each fault on a line.
[[nodiscard]] std::optional<std::vector<Student>> loadGroup(const std::string& file);

} // namespace sparkout::cli
