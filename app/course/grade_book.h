// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/grading.h"
#include "core/workbook/workbook.h"

#include <vector>

namespace sparkout::cli {

/// The marks of a class as a workbook: a sheet with a row for each work, and one with a row for
/// each step.
[[nodiscard]] xlsx::Book gradeBook(const Lesson& lesson, const std::vector<GradedWork>& works);

} // namespace sparkout::cli
