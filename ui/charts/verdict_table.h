// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/light.h"
#include "core/study/outcome.h"
#include "ui/tables/value_table.h"

#include <QIcon>

#include <array>
#include <vector>

namespace sparkout {

[[nodiscard]] QString lightName(Light light); ///< "met", "close to the limit", "not met"
/// The name of the light, or a remark that strips are left and the value does not cover the whole
/// surface.
[[nodiscard]] QString lightName(const ConstraintResult& constraint);

enum class VerdictColumn { requirement, value, limit, margin };

/// The requirements, zone by zone, then those of the part, of the passes and of the settings; null:
/// a group heading.
[[nodiscard]] std::vector<const ConstraintResult*> verdictRows(const Outcome& outcome);

/// The requirements as a table with their lights. Copies have zone and light in separate columns.
/// Without an outcome (null) the table has only headings.
[[nodiscard]] ValueTable verdictTable(const Outcome* outcome, const std::array<QIcon, 3>& icons);

} // namespace sparkout
