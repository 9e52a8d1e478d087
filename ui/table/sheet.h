// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workbook/workbook.h"
#include "ui/table/csv_table.h"

#include <cstddef>
#include <functional>
#include <optional>

/// Tables that may be too long for memory, to be written to a file.
namespace sparkout {

struct SheetColumn {
    /// The number format of a column: this many decimals, or one of these.
    static constexpr int general = xlsx::Column::general, scientific = xlsx::Column::scientific;

    QString name;
    QString unit = {}; ///< unit of its numbers, translated
    int decimals = general;

    [[nodiscard]] QString nameWithUnit() const {
        return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
    }
};

/// A table generated row by row.
struct Sheet {
    QString name;
    std::vector<SheetColumn> columns;
    std::size_t rows = 0;
    /// Fills `cells`, of the number of columns, with a row; on any thread.
    std::function<void(std::size_t row, std::vector<CsvCell>& cells)> fill = {};

    [[nodiscard]] bool hasUnits() const;
};

using xlsx::KeepGoing;
using xlsx::rowsBetweenLooks;

/// The table with the units in a row of their own, and with the decimals that show six digits of
/// its numbers.
[[nodiscard]] Sheet sheetOf(const CsvTable& table, const QString& name);

/// One sheet, or one for each text of the first column, in their order.
[[nodiscard]] std::vector<Sheet> sheetsOf(const CsvTable& table, const QString& name);

/// Like csvBytes(table), with name and unit in one cell; empty after a cancellation.
[[nodiscard]] QByteArray csvBytes(const Sheet& sheet, CsvDialect dialect,
                                  const KeepGoing& keepGoing = {});

inline constexpr std::size_t xlsxRows = xlsx::mostRows;
inline constexpr auto xlsxNameLength = static_cast<qsizetype>(xlsx::mostNameLength);
inline constexpr auto xlsxTextLength = static_cast<qsizetype>(xlsx::mostTextLength);

/// Tables of the window as a workbook, written by core/workbook.
struct Book {
    QString title;
    QString author;
    QString program;           ///< "Sparkout 0.1.0"
    std::vector<Sheet> sheets; ///< at least one
};

/// See xlsx::bytesOf(); the sheets get valid names. Empty after a cancellation, or if a sheet has
/// too many rows: see sheetTooLong().
[[nodiscard]] QByteArray xlsxBytes(const Book& book, const KeepGoing& keepGoing = {});

/// The first sheet with more rows than a workbook can have; null if there is none.
[[nodiscard]] const Sheet* sheetTooLong(const std::vector<Sheet>& sheets);

/// Valid and unique names of sheets: no [ ] : * ? / \, at most 31 characters, none empty.
[[nodiscard]] QStringList sheetNames(const QStringList& wanted);

} // namespace sparkout
