// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/xlsx_book.h"

#include <QHash>

/// The files of a workbook beside its sheets (ECMA-376, part 1).
namespace sparkout::xlsx {

/// Formats of cells, in the order of the file's list; from `decimals` on one a number of decimals.
enum Style { plain, head, unit, text, scientific, decimals };
inline constexpr int mostDecimals = 9;
[[nodiscard]] int styleOf(const SheetColumn& column);
/// For a number among others of any size: as many decimals as six digits of it need.
[[nodiscard]] int styleOf(double value);

/// What XML may hold, escaped.
[[nodiscard]] QByteArray escaped(const QString& text);

/// Every text of the cells once; they stand for it by number.
class SharedTexts {
public:
    [[nodiscard]] int numberOf(const QString& text);
    [[nodiscard]] QByteArray xml() const;

private:
    QHash<QString, int> m_numbers;
    QStringList m_texts;
    qint64 m_uses = 0;
};

[[nodiscard]] QByteArray contentTypes(std::size_t sheets);
[[nodiscard]] QByteArray packageLinks();
/// The heads are printed on every page, of a long sheet the first rows alone.
[[nodiscard]] QByteArray workbook(const QStringList& names, const std::vector<Sheet>& sheets);
inline constexpr std::size_t printedRows = 500;
[[nodiscard]] QByteArray columnLetters(std::size_t column); ///< "A", …, "Z", "AA", …
[[nodiscard]] QByteArray pageSetUp(); ///< A4 across, one page wide, with names and page numbers
[[nodiscard]] QByteArray workbookLinks(std::size_t sheets);
[[nodiscard]] QByteArray styles();
[[nodiscard]] QByteArray coreProperties(const Book& book);
[[nodiscard]] QByteArray programProperties(const Book& book);

} // namespace sparkout::xlsx
