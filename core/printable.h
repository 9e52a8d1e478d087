// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sparkout {

/// A text without what steers a terminal or reverses the reading direction: such characters are
/// shown as \uXXXX, and bytes that are no UTF-8 as \xXX. Texts and file names go through it before
/// they stand in a message of one line.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace sparkout
