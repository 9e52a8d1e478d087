// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sparkout {

/// A text without what steers a terminal or reverses the reading direction: such characters are
/// shown as \uXXXX, and bytes that are no UTF-8 as \xXX. Texts and file names go through it before
/// they stand in a message of one line.
[[nodiscard]] std::string printable(std::string_view text);

/// The same of a text of several lines, whose ends stay. JSON keeps its meaning: \uXXXX is the
/// character in it.
[[nodiscard]] std::string printableLines(std::string_view text);

/// How many bytes the UTF-8 character at the beginning of a text has; 0: there is none. Not empty.
[[nodiscard]] std::size_t characterBytes(std::string_view text);

/// The code of a UTF-8 character of so many bytes.
[[nodiscard]] unsigned characterCode(std::string_view character);

/// Control characters, marks of direction and line ends of Unicode.
[[nodiscard]] bool steersTheDisplay(unsigned code);

} // namespace sparkout
