// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

struct Project;

/// The path of the first input, in the order of the tables, in which two projects differ; of a list
/// whose items are not as many, the list's. Empty when they are the same.
[[nodiscard]] std::string firstDifference(const Project& a, const Project& b);

} // namespace sparkout
