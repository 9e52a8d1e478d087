// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workbook/workbook.h"
#include "ui/tables/csv_table.h"

#include <cstddef>
#include <functional>
#include <optional>

/// Tables that may be too long to stand in memory, on their way to a file.
namespace sparkout {

struct SheetColumn {
    /// How a spreadsheet shows the numbers of a column: with so many decimals, or these.
    static constexpr int general = xlsx::Column::general, scientific = xlsx::Column::scientific;

    QString name;
    QString unit = {}; ///< of its numbers, in the present language
    int decimals = general;

    [[nodiscard]] QString nameWithUnit() const {
        return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
    }
};

/// A table that is made row by row.
struct Sheet {
    QString name;
    std::vector<SheetColumn> columns;
    std::size_t rows = 0;
    /// Puts the cells of a row into `cells`, which holds as many as there are columns; in any
    /// thread.
    std::function<void(std::size_t row, std::vector<CsvCell>& cells)> fill = {};

    [[nodiscard]] bool hasUnits() const;
};

using xlsx::KeepGoing;
using xlsx::rowsBetweenLooks;

/// The table with the units of its header in a row of their own, and as many decimals as its
/// numbers need to show six digits.
[[nodiscard]] Sheet sheetOf(const CsvTable& table, const QString& name);

/// One sheet, or for each text of the first column one, in the order they come.
[[nodiscard]] std::vector<Sheet> sheetsOf(const CsvTable& table, const QString& name);

/// As csvBytes(table), name and unit in one cell; nothing when it was given up.
[[nodiscard]] QByteArray csvBytes(const Sheet& sheet, CsvDialect dialect,
                                  const KeepGoing& keepGoing = {});

} // namespace sparkout
