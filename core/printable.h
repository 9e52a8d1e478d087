// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sparkout {

/// A text without characters that control a terminal or reverse the reading direction: these become
/// \uXXXX, and bytes that are not UTF-8 \xXX. Used for texts and file names in messages of one
/// line.
[[nodiscard]] std::string printable(std::string_view text);

/// Keeps the line ends of a text. JSON keeps its meaning, since \uXXXX denotes the character there.
[[nodiscard]] std::string printableLines(std::string_view text);

/// The number of bytes of the UTF-8 character at the beginning of a non-empty text; 0 if it is
/// invalid.
[[nodiscard]] std::size_t characterBytes(std::string_view text);

/// The code of a UTF-8 character of 1 to 4 bytes.
[[nodiscard]] unsigned characterCode(std::string_view character);

/// Control characters, marks of direction and line ends of Unicode.
[[nodiscard]] bool steersTheDisplay(unsigned code);

} // namespace sparkout
