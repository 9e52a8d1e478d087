// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/course/course_options.h"

namespace sparkout::cli {

/// `course check`: a lesson, a work, or the kept runs of a project, held against the engine.
int runCourseCheck(const CourseOptions& options);

} // namespace sparkout::cli
