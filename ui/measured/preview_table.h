// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"
#include "ui/tables/value_table.h"

#include <string_view>

namespace sparkout {

/// The first rows of a table of measurements as split into cells, by their first lines, with the
/// faults of the cells.
[[nodiscard]] ValueTable previewTable(std::string_view text, const MeasuredTable& table,
                                      const CellFaults& faults = {});

} // namespace sparkout
