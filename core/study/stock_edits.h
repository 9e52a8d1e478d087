// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

/// Edits of a project's stock.
namespace sparkout {

/// Returns whether the stocks of the stages add up to the part's, as validate() requires.
[[nodiscard]] bool stocksAddUp(const Project& project);

/// Returns the project with stocks of the stages that add up to the part's. The first stage takes
/// the stock that the later ones leave, as it does in the cycle anyway [MODEL-7], so that nothing
/// else changes; where they leave none, all stages keep their share of the sum.
[[nodiscard]] Project withFittedStocks(Project project);

} // namespace sparkout
