// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "ui/tables/csv_table.h"

#include <span>
#include <vector>

/// Outputs as columns of a table with all their digits: an interval takes two columns, an estimate
/// three, a share four. Outputs without a label are for programs.
namespace sparkout {

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
