// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/light.h"
#include "core/study/outcome.h"
#include "ui/charts/light_icon.h"
#include "ui/tables/value_table.h"

#include <QString>

#include <vector>

namespace sparkout {

[[nodiscard]] QString lightName(Light light); ///< "holds", "close to the limit", "fails"
/// As the light has it, or why nothing is decided: strips are left and the value is not of the
/// whole surface, or the machine is not known.
[[nodiscard]] QString lightName(const ConstraintResult& constraint);

enum class VerdictColumn { requirement, value, limit, margin };

/// The requirements, zone by zone, then those of the part, of the passes and of the settings; null:
/// a group heading.
[[nodiscard]] std::vector<const ConstraintResult*> verdictRows(const Outcome& outcome);

/// The same as a table with their lights. It is copied with zone and light in columns of their own.
/// Without an outcome (null) the table has its heads only.
[[nodiscard]] ValueTable verdictTable(const Outcome* outcome, const LightIcons& icons);

} // namespace sparkout
