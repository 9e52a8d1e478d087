// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/value_table.h"

#include <QStringList>

/// The shop's numbers as tables.
namespace sparkout {

/// A row a quantity, a column a stage and a last one for the whole cycle; empty without a run.
[[nodiscard]] ValueTable shopTable(const Outcome& outcome);
/// A row a stage, and a last one for the whole cycle; with all digits.
[[nodiscard]] CsvTable stageTable(const ShopNumbers& shop, Operation operation);

/// What lies outside its band and what that means, a sentence each.
[[nodiscard]] QStringList shopRemarks(const ShopNumbers& shop);

} // namespace sparkout
