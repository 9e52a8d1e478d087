// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/run_summary.h"
#include "core/study/run_comparison.h"
#include "ui/tables/value_table.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace sparkout {

/// One input or result in which the runs differ.
struct RunRow {
    QString what; ///< "Cycle › Stage 2 › Axial feed"
    QString unit;
    QStringList shown;          ///< of each run; "–" where it has no such value
    std::vector<CsvCell> cells; ///< the same with all their digits
    bool isResult = false;
};

/// What the runs differ in, in words.
[[nodiscard]] std::vector<RunRow> differingRows(const std::vector<ComparedRun>& runs);

/// The same as a table: a row an input or result under a row that names which of the two, a column
/// a run, the present one first. It is copied with all digits and the units in a column of their
/// own.
[[nodiscard]] ValueTable runTable(const std::vector<RunRow>& rows, const QStringList& runs);

/// What a kept run has otherwise now, a line each: "RZ1 › Roundness: 1.23 → 1.25 µm".
[[nodiscard]] QStringList changesShown(const ReadSummary& kept, const RunSummary& now);

/// All inputs the model reads, in the order of the tables: a row an input with its symbol, unit,
/// value and path in the project file.
[[nodiscard]] CsvTable inputTable(const Project& project);

/// What the cycle as a whole comes to, a row a number or verdict.
[[nodiscard]] CsvTable cycleTable(const RunSummary& summary, const Project& inputs);

} // namespace sparkout
