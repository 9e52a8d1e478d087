// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// `course` with its arguments, as typed.
struct CourseOptions {
    std::string command; ///< check, variants or grade
    std::vector<std::string> operands;
    std::string group, answers, folder;
    std::string output; ///< the workbook
    std::optional<std::uint32_t> seed;
    bool json = false, csv = false, xlsx = false, force = false;
};

/// Reads the arguments; what is wrong is said. Returns the exit status of it, or `done`.
[[nodiscard]] int parseCourse(const std::vector<std::string>& arguments, CourseOptions& options);

} // namespace sparkout::cli
