// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workbook/workbook.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

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
