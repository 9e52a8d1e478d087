// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

/// The commands of the course. Each returns the exit status.
namespace sparkout::cli {

/// Checks a lesson, a work, or the kept runs of a project with the engine.
int runCourseCheck(const manual::Given& given);
/// Marks the works of a folder.
int runCourseGrade(const manual::Given& given);
/// Writes a work for each student of a list, and the two tables.
int runCourseVariants(const manual::Given& given);

} // namespace sparkout::cli
