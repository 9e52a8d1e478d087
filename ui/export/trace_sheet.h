// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/sheet.h"

namespace sparkout {

/// The trace, a row for every time a radius passed under the wheel, with the numbers of
/// `sparkout-cli simulate --trace`.
[[nodiscard]] Sheet traceSheet(const OutcomePtr& outcome, const QString& name);

/// With a sheet for each zone or section.
[[nodiscard]] std::vector<Sheet> traceSheets(const OutcomePtr& outcome);

} // namespace sparkout
