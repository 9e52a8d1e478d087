// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/value_table.h"

/// Results as tables with all their digits, in the present language: what the tables of the window
/// save, and the export of a whole result.
namespace sparkout {

/// A row a requirement: value, limit, margin, their unit, and where in the cycle it is worst.
[[nodiscard]] CsvTable requirementTable(const std::vector<ConstraintResult>& requirements,
                                        Operation operation);

/// The form of zones that hold several sections, a row a zone; without rows where none does.
[[nodiscard]] CsvTable formTable(const Outcome& outcome);
/// The same as it is read: a row a quantity, a column a zone.
[[nodiscard]] ValueTable formValues(const Outcome& outcome);

/// A row a zone or section as the cycle leaves it.
[[nodiscard]] CsvTable zoneTable(const Outcome& outcome);

} // namespace sparkout
