// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/course/course_options.h"

namespace sparkout::cli {

/// `course variants`: a work for each student of a list, and the two tables.
int runCourseVariants(const CourseOptions& options);

} // namespace sparkout::cli
