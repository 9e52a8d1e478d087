// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QLocale>
#include <QString>
#include <QStringList>

#include <variant>
#include <vector>

/// Tables on their way to a spreadsheet.
namespace sparkout {

/// A cell: empty, a number, or a text. A number that is not finite counts as empty.
using CsvCell = std::variant<std::monostate, double, QString>;

/// Names with their units over rows of cells.
struct CsvTable {
    QStringList header;
    std::vector<std::vector<CsvCell>> rows;
    bool byPlace = false;  ///< the first column names a place; a workbook has a sheet for each
    bool ownUnits = false; ///< every row has a unit of its own, so columns have no common digits

    [[nodiscard]] bool empty() const { return rows.empty(); }
};

enum class CsvDialect {
    russianExcel, ///< semicolons, decimal commas
    english,      ///< commas, decimal points (RFC 4180)
};

/// UTF-8 with a byte-order mark, by which Excel knows it; lines ended by CR LF. Numbers are written
/// so that they read back as the same double; a text that a spreadsheet would take for a formula
/// gets an apostrophe in front.
[[nodiscard]] QByteArray csvBytes(const CsvTable& table, CsvDialect dialect);

/// The byte-order mark, and a line of cells.
[[nodiscard]] QByteArray csvBegin();
[[nodiscard]] QByteArray csvLine(const std::vector<CsvCell>& cells, CsvDialect dialect);

/// Lines of cells separated by tabs, for the clipboard; numbers as the locale writes them, with all
/// their digits and no group separators.
[[nodiscard]] QString tabSeparated(const CsvTable& table, const QLocale& locale);

/// The text, with an apostrophe in front if it begins with = + - @, a tab or a carriage return.
[[nodiscard]] QString harmlessCell(const QString& text);

} // namespace sparkout
