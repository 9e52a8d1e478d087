// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/tables/csv_line.h"

#include <span>
#include <string>

/// Outputs as columns of a CSV table: an interval takes two columns, an estimate and a share three.
namespace sparkout {

void addCsvHeads(CsvLine& line, const OutputRow& row, OutputKind kind);
void addCsvCells(CsvLine& line, OutputKind kind, const OutputValue& value);

/// A line of headings, and a line for each owner.
template <class Owner, class Owners>
[[nodiscard]] std::string outputsCsv(std::span<const Output<Owner>> rows, const Owners& owners) {
    CsvLine line;
    for (const Output<Owner>& row : rows) {
        addCsvHeads(line, row, row.kind());
    }
    std::string text = line.end();
    for (const Owner& owner : owners) {
        for (const Output<Owner>& row : rows) {
            if (*row.columnName()) {
                addCsvCells(line, row.kind(), row.of(owner));
            }
        }
        text += line.end();
    }
    return text;
}

} // namespace sparkout
