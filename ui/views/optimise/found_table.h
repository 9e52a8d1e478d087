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

/// The answer beside what it is held against: a row for the cycle compared with (with its least
/// relative margin, if that is known), the quickest one for the nominal part alone, the best of the
/// grid, the refined one, the bound of a search that was stopped and the stepless limit, as far as
/// there are such. Columns that no row fills are left out. Empty where no cycle was found.
[[nodiscard]] ValueTable answerTable(const SearchOutcome& outcome, std::optional<double> before_s,
                                     std::optional<double> beforeMargin = {});

} // namespace sparkout
