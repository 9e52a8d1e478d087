// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <vector>

namespace sparkout {

/// Rounds a number to ten decimals, as one would write it: 0.15 − 6·0.01 is 0.09.
[[nodiscard]] double asWritten(double value);

/// Returns the single levels; a step that ends within a millionth of its length at `to` reaches it.
[[nodiscard]] std::vector<double> levelValues(const Levels& levels);

/// Returns the number of levels without listing them.
[[nodiscard]] double levelCount(const Levels& levels);

} // namespace sparkout
