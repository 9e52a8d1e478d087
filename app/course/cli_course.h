// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sparkout::cli {

/// `course check|variants|grade …`: the arguments after `course`. Returns the exit status.
int runCourse(const std::vector<std::string>& arguments);

} // namespace sparkout::cli
