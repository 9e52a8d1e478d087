// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// The project file: one UTF-8 JSON text, read and written only by the tables.
namespace sparkout {

inline constexpr int projectVersion = 1; ///< version of a file of one surface
inline constexpr int newestVersion = 2;  ///< with several, see core/setup/setup_file.h

/// Limits of the reader; larger numbers are refused.
namespace limits {
inline constexpr std::size_t fileBytes = 32u << 20;
inline constexpr std::size_t depth = 64;
inline constexpr std::size_t values = 2'000'000;
inline constexpr std::size_t stringBytes = 64u << 10;
} // namespace limits

struct ReadResult {
    std::optional<Project> project; ///< given without errors
    /// Given if every value was read and is in its range, but a rule between values is violated, or
    /// a kept run has faults: unfinished work that the window can open.
    std::optional<Project> unfinished;
    Issues issues; ///< errors, or warnings with a project
};

/// Reads and validates a project text. Returns all faults at once.
[[nodiscard]] ReadResult readProject(std::string_view text);

/// After a stop the result is empty: neither a project nor issues.
[[nodiscard]] ReadResult readProject(std::string_view text, const std::stop_token& stop);

/// The text of a project: equal projects give equal bytes. Numbers have the shortest digits that
/// read back to the same double.
[[nodiscard]] std::string writeProject(const Project& project);

/// Whether two projects have the same values.
[[nodiscard]] bool sameProject(const Project& a, const Project& b);

/// Whether an input, or the inputs within a struct or list, count in a comparison.
using InputFilter = bool (*)(std::string_view path);

/// The path of the first input, in the order of the tables, in which two projects differ; of a list
/// with another number of items, the list's. Empty if they are the same. Compares only inputs
/// accepted by `counts`, or all without it.
[[nodiscard]] std::string firstDifference(const Project& a, const Project& b,
                                          InputFilter counts = nullptr);

} // namespace sparkout
