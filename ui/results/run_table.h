// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/run_summary.h"
#include "core/study/run_comparison.h"
#include "ui/table/value_table.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace sparkout {

/// An input or result in which the runs differ.
struct RunRow {
    QString what; ///< "Cycle › Stage 2 › Axial feed"
    QString unit;
    QStringList shown;          ///< for each run; "–" if it does not have this value
    std::vector<CsvCell> cells; ///< with all their digits
    bool isResult = false;
};

/// The differences of the runs, as text.
[[nodiscard]] std::vector<RunRow> differingRows(const std::vector<ComparedRun>& runs);

/// The differences as a table: a row for each input or result below a group heading, a column for
/// each run, the current one first. Copies have all digits, and the units in a separate column.
[[nodiscard]] ValueTable runTable(const std::vector<RunRow>& rows, const QStringList& runs);

/// The changes of a kept run's values, one per line: "RZ1 › Roundness: 1.23 → 1.25 µm".
[[nodiscard]] QStringList changesShown(const ReadSummary& kept, const RunSummary& now);

/// All inputs of the model, in the order of the tables: a row for each with its symbol, unit, value
/// and path in the project file.
[[nodiscard]] CsvTable inputTable(const Project& project);

/// What the cycle as a whole comes to, a row a number or verdict.
[[nodiscard]] CsvTable cycleTable(const RunSummary& summary, const Project& inputs);

} // namespace sparkout
