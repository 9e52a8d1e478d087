// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/grading.h"
#include "core/lesson/lesson.h"
#include "ui/tables/value_table.h"

#include <vector>

namespace sparkout {

/// The marks of a class: a row for each work, the points by step, their sum and remarks.
[[nodiscard]] ValueTable marksTable(const Lesson& lesson, const std::vector<GradedWork>& works);

/// The remarks on a work, on one line.
[[nodiscard]] QString workRemarks(const GradedWork& work);

} // namespace sparkout
