// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"

#include <optional>

namespace sparkout::report {

/// The cross-sections at the end of the cycle, magnified.
[[nodiscard]] Figure profilesFigure(const OutcomePtr& outcome);

/// The actual feed over the stock left below its limits, at a place of the cycle; empty without
/// cuts.
[[nodiscard]] std::optional<Figure> limitsFigure(const OutcomePtr& outcome, const Place& at);

} // namespace sparkout::report
