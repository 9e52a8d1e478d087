// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
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

/// The files of a workbook besides its sheets (ECMA-376, part 1).
namespace sparkout::xlsx {

/// Cell formats, in the order of the file's list; from `decimals` on the number of decimals.
enum Style { plain, head, unit, text, scientific, decimals };
inline constexpr int mostDecimals = 9;
[[nodiscard]] int styleOf(const Column& column);
/// For a number in a column of any magnitude: the decimals for six digits.
[[nodiscard]] int styleOf(double value);

/// The text escaped for XML, and cut to the limit of a cell. Invalid UTF-8 becomes '?'.
[[nodiscard]] std::string escaped(std::string_view text);

/// In UTF-16 units, as workbooks count.
[[nodiscard]] std::size_t lengthOf(std::string_view text);

/// The texts of the cells, each once; cells refer to them by number.
class SharedTexts {
public:
    [[nodiscard]] std::size_t numberOf(const std::string& text);
    [[nodiscard]] std::string xml() const;

private:
    std::unordered_map<std::string, std::size_t> m_numbers;
    std::vector<const std::string*> m_texts; ///< keys of the map, by number
    std::uint64_t m_uses = 0;
};

[[nodiscard]] std::string contentTypes(std::size_t sheets);
[[nodiscard]] std::string packageLinks();
/// The heads are printed on every page, of a long sheet only the first rows.
[[nodiscard]] std::string sheetList(const std::vector<Sheet>& sheets);
inline constexpr std::size_t printedRows = 500;
[[nodiscard]] std::string columnLetters(std::size_t column); ///< "A", …, "Z", "AA", …
[[nodiscard]] std::string pageSetUp(); ///< A4 across, one page wide, with names and page numbers
[[nodiscard]] std::string sheetLinks(std::size_t sheets);
[[nodiscard]] std::string styles();
[[nodiscard]] std::string coreProperties(const Book& book);
[[nodiscard]] std::string programProperties(const Book& book);

} // namespace sparkout::xlsx
