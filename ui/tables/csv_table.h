// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table_reader.h"

#include <QByteArray>
#include <QLocale>
#include <QString>
#include <QStringList>

#include <variant>
#include <vector>

/// Tables for spreadsheets.
namespace sparkout {

/// A cell: empty, a number, or a text. A number that is not finite counts as empty.
using CsvCell = std::variant<std::monostate, double, QString>;

/// Names with their units over rows of cells.
struct CsvTable {
    QStringList header;
    std::vector<std::vector<CsvCell>> rows;
    bool byPlace = false;  ///< the first column is a place; a workbook has a sheet for each
    bool ownUnits = false; ///< every row has its own unit, so columns have no common decimals

    [[nodiscard]] bool empty() const { return rows.empty(); }
};

enum class CsvDialect {
    russianExcel, ///< semicolons, decimal commas
    english,      ///< commas, decimal points (RFC 4180)
};

/// UTF-8 with a byte-order mark, by which Excel recognises it; lines end with CR LF; cells as
/// CsvLine writes them.
[[nodiscard]] QByteArray csvBytes(const CsvTable& table, CsvDialect dialect);

/// The byte-order mark, and a line of cells.
[[nodiscard]] QByteArray csvBegin();
[[nodiscard]] QByteArray csvLine(const std::vector<CsvCell>& cells, CsvDialect dialect);

/// Lines of cells separated by tabs, for the clipboard; numbers in the locale's format, with all
/// their digits and without group separators.
[[nodiscard]] QString tabSeparated(const CsvTable& table, const QLocale& locale);

[[nodiscard]] TableDialect tableDialect(CsvDialect dialect);

} // namespace sparkout
