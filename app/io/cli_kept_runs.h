// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace sparkout::cli {

/// Prints the kept runs of a project whose results differ from the engine's to stderr, one on a
/// line; returns their names.
std::vector<std::string> printUntrueRuns(const std::string& file, const Project& project);

} // namespace sparkout::cli
