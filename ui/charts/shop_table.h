// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/value_table.h"

#include <QStringList>

/// The shop's numbers as tables.
namespace sparkout {

/// A row for each quantity, a column for each stage and a last one for the whole cycle; empty
/// without a run.
[[nodiscard]] ValueTable shopTable(const Outcome& outcome);
/// A row for each stage, and a last one for the whole cycle; with all digits.
[[nodiscard]] CsvTable stageTable(const ShopNumbers& shop, Operation operation);

/// The values outside their band and their meaning, in sentences.
[[nodiscard]] QStringList shopRemarks(const ShopNumbers& shop);

} // namespace sparkout
