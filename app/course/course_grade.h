// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/course/course_options.h"

namespace sparkout::cli {

/// `course grade`: marks the works of a folder.
int runCourseGrade(const CourseOptions& options);

} // namespace sparkout::cli
