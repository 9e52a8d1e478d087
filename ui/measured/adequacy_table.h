// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/project/project.h"
#include "ui/tables/value_table.h"

#include <vector>

namespace sparkout {

/// Measured and predicted values: a row for each quantity in a zone or section; copied with all its
/// numbers.
[[nodiscard]] ValueTable adequacyTable(const Project& project,
                                       const std::vector<AdequacyRow>& rows);

} // namespace sparkout
