// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/table/csv_table.h"
#include "ui/table/value_table.h"

#include <QStringList>

/// Results and the shop's numbers as tables with all their digits, in the current language: for
/// saving the tables of the window, and for exporting a whole result.
namespace sparkout {

/// A row for each requirement: value, limit, margin, their unit, and its worst place in the cycle.
[[nodiscard]] CsvTable requirementTable(const std::vector<ConstraintResult>& requirements,
                                        Operation operation);

/// The form of zones with several sections, a row for each zone; without rows if there are none.
[[nodiscard]] CsvTable formTable(const Outcome& outcome);
/// The displayed form: a row for each quantity, a column for each zone.
[[nodiscard]] ValueTable formValues(const Outcome& outcome);

/// The final state of each zone or section, one per row.
[[nodiscard]] CsvTable zoneTable(const Outcome& outcome);

/// The shop's numbers: a row for each quantity, a column for each stage and a last one for the
/// whole cycle; empty without a run.
[[nodiscard]] ValueTable shopTable(const Outcome& outcome);
/// A row for each stage, and a last one for the whole cycle; with all digits.
[[nodiscard]] CsvTable stageTable(const ShopNumbers& shop, Operation operation);

/// The values outside their band and their meaning, in sentences.
[[nodiscard]] QStringList shopRemarks(const ShopNumbers& shop);

} // namespace sparkout
