// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"
#include "ui/tables/value_table.h"

#include <optional>

namespace sparkout {

/// Columns of foundTable(); the last two of a search between dressings alone.
enum class FoundColumn { time, cycle, stages, change, gap, margin, parts, cost };

/// The best cycles that a search came upon, the quickest first, against the time of the cycle
/// compared with, if it ends by itself.
[[nodiscard]] ValueTable foundTable(const SearchOutcome& outcome, std::optional<double> before_s);

} // namespace sparkout
