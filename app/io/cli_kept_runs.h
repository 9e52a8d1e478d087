// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace sparkout::cli {

/// Names the kept runs of a project whose numbers are not the engine's, on stderr, one a line;
/// returns their names.
std::vector<std::string> printUntrueRuns(const std::string& file, const Project& project);

} // namespace sparkout::cli
