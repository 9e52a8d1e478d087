// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

/// Workbooks for Excel, LibreOffice and others (Office Open XML): the only writer, for window and
/// command line. All texts are UTF-8.
namespace sparkout::xlsx {

inline constexpr std::size_t mostRows = 1'048'576;    ///< rows of a sheet, with its head
inline constexpr std::size_t mostNameLength = 31;     ///< length of a sheet's name, in UTF-16 units
inline constexpr std::size_t mostTextLength = 32'767; ///< length of a cell's text, in UTF-16 units
inline constexpr std::size_t rowsBetweenLooks = 500;  ///< between checks for a cancellation

/// A cell: empty, a number, or a text. A number that is not finite counts as empty.
using Cell = std::variant<std::monostate, double, std::string>;

struct Column {
    /// The number format: this number of decimals, or one of these.
    static constexpr int general = -1, scientific = -2;

    std::string name;
    std::string unit = {};
    int decimals = general;
};

/// A table generated row by row.
struct Sheet {
    std::string name; ///< a valid and unique name: see sheetNames() of the window
    std::vector<Column> columns;
    std::size_t rows = 0;
    /// Fills `cells`, of the number of columns, with a row.
    std::function<void(std::size_t row, std::vector<Cell>& cells)> fill = {};

    [[nodiscard]] bool hasUnits() const;
};

struct Book {
    std::string title;
    std::string author;
    std::string program;       ///< "Sparkout 0.1.0"
    std::vector<Sheet> sheets; ///< at least one
};

/// Receives the finished share, from 0 to 1; returns false to cancel.
using KeepGoing = std::function<bool(double share)>;

/// Whether a sheet can have this number of rows besides its head.
[[nodiscard]] constexpr bool takesRows(std::size_t rows, bool hasUnits) {
    return rows + (hasUnits ? 2 : 1) <= mostRows;
}

/// Numbers read back as the same double; texts remain texts, whatever they begin with. The names of
/// the columns, and their units in a row of their own, stay visible. Equal content gives equal
/// bytes. Empty after a cancellation, or if a sheet has too many rows.
[[nodiscard]] std::string bytesOf(const Book& book, const KeepGoing& keepGoing = {});

} // namespace sparkout::xlsx
