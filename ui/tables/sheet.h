// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workbook/workbook.h"
#include "ui/tables/csv_table.h"

#include <cstddef>
#include <functional>
#include <optional>

/// Tables that may be too long for memory, to be written to a file.
namespace sparkout {

struct SheetColumn {
    /// The number format of a column: so many decimals, or one of these.
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

} // namespace sparkout
