// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"
#include "core/issue.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// The file of a student's work, `.sparkout-work`: one UTF-8 JSON text, read and written by the
/// tables, its lesson as in a lesson file.
namespace sparkout {

inline constexpr const char* workFormat = "sparkout-work";
inline constexpr int workVersion = 1;

struct ReadWork {
    std::optional<Work> work; ///< given without errors; its seals may be broken
    Issues issues;            ///< those of its lesson below "/lesson"
};

/// Reads and checks a work within the limits of a project file. Returns all faults at once.
[[nodiscard]] ReadWork readWork(std::string_view text, const std::stop_token& stop = {});

/// The text of a work: the same work, the same bytes.
[[nodiscard]] std::string writeWork(const Work& work);

} // namespace sparkout
