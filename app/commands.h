// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/lesson/lesson.h"
#include "core/lesson/work.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// Reads and checks a lesson; prints each fault on a line.
[[nodiscard]] std::optional<Lesson> loadLesson(const std::string& file);

/// Reads a list of students; prints each fault on a line.
[[nodiscard]] std::optional<std::vector<Student>> loadGroup(const std::string& file);

// The commands of the course. Each returns the exit status.

/// Checks a lesson, a work, or the kept runs of a project with the engine.
int runCourseCheck(const manual::Given& given);
/// Marks the works of a folder.
int runCourseGrade(const manual::Given& given);
/// Writes a work for each student of a list, and the two tables.
int runCourseVariants(const manual::Given& given);

// The other commands that have a source of their own. Each returns the exit status.

[[nodiscard]] int runBatchCommand(const manual::Given& given);
[[nodiscard]] int runBatchMerge(const manual::Given& given);
/// The parts between two dressings of the wheel.
[[nodiscard]] int runDressingCommand(const manual::Given& given);
/// Writes a project with a starting cycle for a drawing.
[[nodiscard]] int runNewCommand(const manual::Given& given);
/// `optimize`; prints its progress to the standard error.
[[nodiscard]] int runOptimise(const manual::Given& given);
/// Decides for which stocks the cycle of each surface is fit.
[[nodiscard]] int runPhasesCommand(const manual::Given& given);
/// Finds changes of one setting that make an unfit cycle fit.
[[nodiscard]] int runRemediesCommand(const manual::Given& given);
[[nodiscard]] int runSweepCommand(const manual::Given& given);
/// Names what can have left the waves counted on a part.
[[nodiscard]] int runWavesCommand(const manual::Given& given);

} // namespace sparkout::cli
