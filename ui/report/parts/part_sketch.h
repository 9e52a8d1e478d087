// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"

namespace sparkout::report {

/// The part between its supports with its dimensions, the zones or sections and the gauge.
[[nodiscard]] Figure partSketch(const OutcomePtr& outcome);

} // namespace sparkout::report
