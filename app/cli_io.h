// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstdio>
#include <optional>
#include <string>

namespace sparkout::cli {

enum Exit {
    done = 0,
    refused = 1,
    usage = 2,
    cannotReachSize = 3,
    requirementFails = 4,
    nothingFeasible = 5,
};

void print(std::FILE* stream, const std::string& text);

/// Says what is wrong with the command line; the exit status.
int usageError(const std::string& message);

/// Reads and checks a project; prints every fault, one a line.
[[nodiscard]] std::optional<Project> load(const std::string& file);

/// Writes a file; prints why not. The exit status.
[[nodiscard]] int save(const std::string& file, const std::string& content);

[[nodiscard]] bool isSameFile(const std::string& a, const std::string& b);

} // namespace sparkout::cli
