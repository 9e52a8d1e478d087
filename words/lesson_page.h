// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The help page of all keys of a lesson file and of a student's work, and of all figures of a
/// lesson's goals: Markdown, made from the tables.
[[nodiscard]] std::string lessonPage();

/// The JSON Schema (draft 2020-12) of a lesson and of a student's work, made from the tables like
/// projectSchema(); their project is that of project.schema.json.
[[nodiscard]] std::string lessonSchema();

} // namespace sparkout
