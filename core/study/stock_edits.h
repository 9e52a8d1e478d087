// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

/// Edits of a project that have to do with the stock.
namespace sparkout {

/// Whether the stocks of the stages add up to the part's, as validate() asks.
[[nodiscard]] bool stocksAddUp(const Project& project);

/// The project with stocks of the stages that add up to the part's. The first stage takes what the
/// later ones leave, as it does in the cycle anyway [MODEL-7], so that nothing else changes; where
/// they leave nothing, all stages keep their share of the sum.
[[nodiscard]] Project withFittedStocks(Project project);

} // namespace sparkout
