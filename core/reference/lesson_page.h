// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The help page of all keys of a lesson file and of a student's work, and of all figures of a
/// lesson's goals: Markdown, made from the tables.
[[nodiscard]] std::string lessonPage();

} // namespace sparkout
