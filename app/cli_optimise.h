// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sparkout::cli {

/// `optimize`, with the arguments behind it; the exit status. Progress goes to the standard error.
[[nodiscard]] int runOptimise(const std::vector<std::string>& arguments);

} // namespace sparkout::cli
