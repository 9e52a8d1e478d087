// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/charts/verdict_table.h"

#include <QString>

/// The sentences of the verdict, plain text.
namespace sparkout::verdict {

[[nodiscard]] QString time(const SimulationResult& result);   ///< "2.41 min (144.6 s)"
[[nodiscard]] QString status(const SimulationResult& result); ///< with what is short of the size
/// "Meets the drawing", or the worst requirement that does not hold.
[[nodiscard]] QString overall(const Outcome& outcome);
[[nodiscard]] Light overallLight(const Outcome& outcome);

} // namespace sparkout::verdict
