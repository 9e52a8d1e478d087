// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/course/cli_course.h"

#include "app/course/course_check.h"
#include "app/course/course_grade.h"
#include "app/course/course_options.h"
#include "app/course/course_variants.h"
#include "app/io/exit_status.h"

namespace sparkout::cli {

int runCourse(const std::vector<std::string>& arguments) {
    CourseOptions options;
    if (const int failed = parseCourse(arguments, options)) {
        return failed;
    }
    return options.command == "check"      ? runCourseCheck(options)
           : options.command == "variants" ? runCourseVariants(options)
                                           : runCourseGrade(options);
}

} // namespace sparkout::cli
