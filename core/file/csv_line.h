// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_table.h"

#include <cstdint>
#include <string>
#include <string_view>

/// Writes tables that TableReader reads back identically, cell by cell.
namespace sparkout {

/// Whether a spreadsheet would take a cell with this text for a formula: it begins with = + - @, a
/// tab or a carriage return.
[[nodiscard]] bool readsAsFormula(std::string_view text);

/// A text as a cell: quoted if needed, with an apostrophe before a text that a spreadsheet would
/// take for a formula, and with characters that control a terminal or the reading direction, except
/// tabs and line ends, as \uXXXX. Not for numbers.
[[nodiscard]] std::string csvCell(std::string_view text, char delimiter = ',');

/// The text from which csvCell() made a cell, given without its quotation marks.
[[nodiscard]] std::string textOfCell(std::string_view cell);
/// Whether csvCell() may have changed the text of the cell.
[[nodiscard]] bool isChangedInCell(std::string_view cell);

/// A line of a table being written.
class CsvLine {
public:
    explicit CsvLine(TableDialect dialect = {}) : m_dialect(dialect) {}

    CsvLine& text(std::string_view text);
    /// Reads back as the same double; an empty cell if it is not finite.
    CsvLine& number(double value);
    CsvLine& whole(std::int64_t value);
    CsvLine& empty() { return put({}); }
    /// The line with its end; leaves nothing behind.
    [[nodiscard]] std::string end(std::string_view lineEnd = "\n");

private:
    CsvLine& put(std::string_view cell);

    TableDialect m_dialect;
    std::string m_line;
    bool m_hasCells = false;
};

} // namespace sparkout
