// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sparkout {

struct Project;

/// Whether an input, or the inputs within a struct or list, count in a comparison.
using InputFilter = bool (*)(std::string_view path);

/// The path of the first input, in the order of the tables, in which two projects differ; of a list
/// with another number of items, the list's. Empty if they are the same. Compares only inputs
/// accepted by `counts`, or all without it.
[[nodiscard]] std::string firstDifference(const Project& a, const Project& b,
                                          InputFilter counts = nullptr);

} // namespace sparkout
