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

/// Whether a spreadsheet would take a cell of this text for a formula: it begins with = + - @, a
/// tab or a carriage return.
[[nodiscard]] bool readsAsFormula(std::string_view text);

/// A text as a cell of a CSV file: printable, in quotation marks if need be, and with an apostrophe
/// in front of what a spreadsheet would take for a formula. Numbers are no texts.
[[nodiscard]] std::string csvCell(std::string_view text, char separator = ',');

} // namespace sparkout
