// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"
#include "ui/table/value_table.h"

#include <optional>

namespace sparkout {

/// Columns of foundTable(); the last two only for a search between dressings.
enum class FoundColumn { time, cycle, stages, change, gap, margin, parts, cost };

/// The best cycles found by a search, the quickest first, compared with the time of the reference
/// cycle, if that ends by itself.
[[nodiscard]] ValueTable foundTable(const SearchOutcome& outcome, std::optional<double> before_s);

/// The answer and its references: rows for the reference cycle (with its least relative margin, if
/// known), the quickest cycle for the nominal part alone, the best of the grid, the refined one,
/// the bound of a stopped search and the stepless limit, as far as available. Empty columns are
/// omitted. Empty if no cycle was found.
[[nodiscard]] ValueTable answerTable(const SearchOutcome& outcome, std::optional<double> before_s,
                                     std::optional<double> beforeMargin = {});

} // namespace sparkout
