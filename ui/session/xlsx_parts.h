// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/xlsx_book.h"

#include <QHash>

/// The files of a workbook beside its sheets (ECMA-376, part 1).
namespace sparkout::xlsx {

/// Formats of cells, in the order of the file's list; from `decimals` on one a number of decimals.
enum Style { plain, head, unit, text, scientific, decimals };
inline constexpr int mostDecimals = 9;
[[nodiscard]] int styleOf(const SheetColumn& column);

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
[[nodiscard]] QByteArray workbook(const QStringList& names);
[[nodiscard]] QByteArray workbookLinks(std::size_t sheets);
[[nodiscard]] QByteArray styles();
[[nodiscard]] QByteArray coreProperties(const Book& book);
[[nodiscard]] QByteArray programProperties(const Book& book);

} // namespace sparkout::xlsx
