// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_outputs.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/value_table.h"

#include <string>
#include <string_view>

namespace sparkout {

/// The figures of one characteristic of a batch: a column for each zone or section, a row for each
/// figure. Unless `tellsIndices` is set, the interval of the mean, Pp and Ppk are dashes.
[[nodiscard]] ValueTable batchFigures(const BatchSummary& summary, const std::string& name,
                                      bool tellsIndices);

/// One figure of a characteristic as displayed, by the key of its output; a dash if it has no
/// value.
[[nodiscard]] QString figureText(const CharacteristicFigures& figures, std::string_view key);

/// All figures of all characteristics with all their digits: a row for each characteristic of a
/// place.
[[nodiscard]] CsvTable batchFiguresTable(const BatchSummary& summary);

} // namespace sparkout
