// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report.h"
#include "ui/session/outcome.h"

#include <optional>

namespace sparkout::report {

/// The part between its supports with its dimensions, the zones or sections and the gauge.
[[nodiscard]] Figure partSketch(const OutcomePtr& outcome);

/// The feeds of the whole cycle by zone or section; nothing when it was too long to be recorded.
[[nodiscard]] std::optional<Figure> feedsFigure(const OutcomePtr& outcome);

} // namespace sparkout::report
