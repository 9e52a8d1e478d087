// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/grading.h"
#include "core/lesson/lesson.h"
#include "ui/tables/value_table.h"

#include <vector>

namespace sparkout {

/// The marks of a class: a row a work, the points by step, their sum and what is to be looked at.
[[nodiscard]] ValueTable marksTable(const Lesson& lesson, const std::vector<GradedWork>& works);

/// What is to be looked at in a work, in one line.
[[nodiscard]] QString workRemarks(const GradedWork& work);

} // namespace sparkout
