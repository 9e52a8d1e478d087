// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"

namespace sparkout::report {

/// The cycle card: what the operator sets and what the part comes out as, in the layout of an
/// operation card. Of an outcome that ran. `file` is the path of the project, or empty.
[[nodiscard]] Report cycleCard(const OutcomePtr& outcome, const QString& file, const QDate& date);

} // namespace sparkout::report
