// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/grading.h"

#include <string>
#include <variant>
#include <vector>

/// The marks of a class as a table: one description for all file formats.
namespace sparkout {

/// Empty, a count, a number, or a text.
using GradeCell = std::variant<std::monostate, int, double, std::string>;

struct GradeColumn {
    static constexpr int asGiven = -1; ///< keep the decimals of the numbers

    std::string key;   ///< "step_1_points": in a file for programs
    std::string title; ///< "step 1": in a file for people
    int decimals = 0;  ///< decimals of its numbers in display
};

struct GradeTable {
    std::vector<GradeColumn> columns;
    std::vector<std::vector<GradeCell>> rows;
};

/// The notation of a work's flags: a function such as flagKey().
struct FlagStyle {
    const char* (*word)(WorkFlag) = flagKey;
    const char* separator = " ";
};

/// A row for every work: name, group, variant, flags, points by step, sum, times.
[[nodiscard]] GradeTable gradeTable(const Lesson& lesson, const std::vector<GradedWork>& works,
                                    FlagStyle flags = {});

/// The table with a row of keys as CSV in UTF-8.
[[nodiscard]] std::string gradesCsv(const Lesson& lesson, const std::vector<GradedWork>& works);

} // namespace sparkout
