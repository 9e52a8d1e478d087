// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

/// A cell as a number, ignoring spaces around it; empty if it is not a finite number in this
/// dialect.
[[nodiscard]] std::optional<double> cellNumber(std::string_view cell, char decimal);

/// A cell for a message: one line, short.
[[nodiscard]] Quoted quotedCell(std::string_view cell);

/// A text of Latin, Greek and Cyrillic letters in lower case, ё as е.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// The unit that a heading of a table states.
enum class ColumnUnit { none, mm, um, s, ms, min, kw, w, n, kn, a, unknown };

/// The unit named by a text, in English or Russian; empty if it names none.
[[nodiscard]] std::optional<ColumnUnit> unitNamed(std::string_view text);

/// Its first name; empty if it has none.
[[nodiscard]] std::string_view nameOf(ColumnUnit unit);

namespace limits {
inline constexpr std::size_t cellBytes = 128U << 10U; ///< largest size of a quoted cell
} // namespace limits

/// The notation of a table.
struct TableDialect {
    char delimiter = ','; ///< , ; tab, or | of lines time|key|value
    char decimal = '.';   ///< . or ,
    friend bool operator==(const TableDialect&, const TableDialect&) = default;
};

/// The dialect of a text, from its first rows. A text with one column has a delimiter that it does
/// not contain.
[[nodiscard]] TableDialect dialectOf(std::string_view text);

/// The rows of a text one by one, each as its cells [RFC 4180]. Rows end with LF, CR LF or CR. A
/// cell may be enclosed in quotation marks, which are not part of it; inside, a doubled one is one,
/// and delimiters and line ends belong to the cell. A quotation mark that does not open a cell, or
/// is not closed before a delimiter or a line end, is an ordinary character. The escapes of
/// csvCell() are undone.
class TableReader {
public:
    enum class Spaces { trimmed, kept }; ///< around cells without quotation marks

    /// The text must outlive it.
    explicit TableReader(std::string_view text, char delimiter, Spaces spaces = Spaces::trimmed);

    /// Reads a row; false at the end.
    [[nodiscard]] bool next();
    /// Of the last row; valid until the next one is read.
    [[nodiscard]] const std::vector<std::string_view>& cells() const { return m_cells; }
    [[nodiscard]] std::size_t line() const { return m_line; } ///< first line of the row, from 1
    [[nodiscard]] bool isBlank() const { return m_cells.size() == 1 && m_cells.front().empty(); }
    [[nodiscard]] bool isEmpty() const; ///< all of its cells are empty
    /// Whether one of its cells begins with a quotation mark that does not close it.
    [[nodiscard]] bool hasStrayMark() const { return m_hasStrayMark; }

private:
    struct Place {
        std::size_t from = 0, size = 0;
        bool isUnescaped = false;
    };
    void readCell();
    void readQuoted(std::size_t open, std::size_t close);
    [[nodiscard]] std::size_t closingMark(std::size_t open) const;
    [[nodiscard]] std::size_t behindSpaces(std::size_t at) const;
    [[nodiscard]] bool endsCell(std::size_t at) const;
    void skipLineEnd();
    void unescapeCells();

    std::string_view m_text;
    char m_delimiter;
    Spaces m_spaces;
    std::size_t m_at = 0;
    std::size_t m_line = 0, m_nextLine = 1;
    bool m_hasStrayMark = false;
    std::vector<Place> m_places;
    std::string m_unescaped; ///< cells of the row that differ from the raw text
    std::vector<std::string_view> m_cells;
};

} // namespace sparkout
