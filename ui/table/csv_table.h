// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_table.h"
#include "core/result.h"

#include <QByteArray>
#include <QLocale>
#include <QString>
#include <QStringList>

#include <span>
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

// Outputs as columns of a table with all their digits: an interval takes two columns, an estimate
// three, a share four. Outputs without a label are for programs.

/// Adds `name` with the ends of its 95 % interval.
void addEstimateHeads(QStringList& header, const QString& name);
void addIntervalCells(std::vector<CsvCell>& cells, const std::optional<Interval>& interval,
                      double factor = 1);

void addHeads(QStringList& header, const OutputRow& row, OutputKind kind, bool revolutions);
void addCells(std::vector<CsvCell>& cells, const OutputRow& row, OutputKind kind,
              const OutputValue& value);

template <class Owner>
void addOutputHeads(QStringList& header, std::span<const Output<Owner>> rows,
                    bool revolutions = false) {
    for (const Output<Owner>& row : rows) {
        if (*row.label) {
            addHeads(header, row, row.kind(), revolutions);
        }
    }
}

/// The cells of an owner; empty without one.
template <class Owner>
void addOutputCells(std::vector<CsvCell>& cells, std::span<const Output<Owner>> rows,
                    const Owner* owner) {
    for (const Output<Owner>& row : rows) {
        if (*row.label) {
            addCells(cells, row, row.kind(), owner ? row.of(*owner) : OutputValue());
        }
    }
}

} // namespace sparkout
