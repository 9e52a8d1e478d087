// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

/// How a table of numbers is written.
struct TableDialect {
    char delimiter = ','; ///< , ; tab, or | of lines time|key|value
    char decimal = '.';   ///< . or ,
    friend bool operator==(const TableDialect&, const TableDialect&) = default;
};

/// The dialect of a text, from its first lines. A text of one column has a delimiter that it does
/// not contain.
[[nodiscard]] TableDialect dialectOf(std::string_view text);

/// The lines of a text one by one, without their ends and without a byte order mark.
class TableLines {
public:
    explicit TableLines(std::string_view text);
    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    [[nodiscard]] std::size_t number() const { return m_number; } ///< of the last one, from 1
    [[nodiscard]] std::string_view next();

private:
    std::string_view m_rest;
    std::size_t m_number = 0;
};

/// The cells of a line, without spaces around them and without quotation marks; what stands between
/// these is not taken apart. `cells` is used again.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// A cell as a number; nothing where it is none in this dialect. Finite.
[[nodiscard]] std::optional<double> cellNumber(std::string_view cell, char decimal);

/// A cell as it may stand in a message: one line, short.
[[nodiscard]] Quoted quotedCell(std::string_view cell);

/// A text of Latin, Greek and Cyrillic letters in lower case.
[[nodiscard]] std::string lowerCase(std::string_view text);

} // namespace sparkout
