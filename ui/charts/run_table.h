// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/run_summary.h"
#include "ui/charts/verdict_model.h"
#include "ui/tables/csv_table.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace sparkout {

/// A run as a column of the table: its inputs and its summary, each null where it is not known.
struct ComparedValues {
    QString name;
    const Project* inputs = nullptr;
    const ReadSummary* summary = nullptr;
};

/// One input or result in which the runs differ.
struct RunRow {
    QString what; ///< "Cycle › Stage 2 › Axial feed"
    QString unit;
    QStringList shown;          ///< of each run; "–" where it has no such value
    std::vector<CsvCell> cells; ///< the same with all their digits
    bool isResult = false;
};

/// The inputs, then the results, in which what is shown of the runs differs, in the order of the
/// tables; inputs the model reads in none of them are left out.
[[nodiscard]] std::vector<RunRow> differingRows(const std::vector<ComparedValues>& runs);

/// What a kept run has otherwise now, a line each: "RZ1 › Roundness: 1.23 → 1.25 µm".
[[nodiscard]] QStringList changesShown(const ReadSummary& kept, const RunSummary& now);

/// All inputs the model reads, in the order of the tables: a row an input with its symbol, unit,
/// value and path in the project file.
[[nodiscard]] CsvTable inputTable(const Project& project);

/// What the cycle as a whole comes to, a row a number or verdict.
[[nodiscard]] CsvTable cycleTable(const RunSummary& summary);

/// The verdict's light by a summary alone; none where it holds no requirement.
[[nodiscard]] std::optional<Light> verdictOf(const RunSummary& summary);

} // namespace sparkout
