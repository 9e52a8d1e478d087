// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <vector>

namespace sparkout {

/// The number as one would write it, with ten decimals at most: 0.15 − 6·0.01 is 0.09.
[[nodiscard]] double asWritten(double value);

/// The levels one by one; a step that ends within a millionth of it at `to` reaches it.
[[nodiscard]] std::vector<double> levelValues(const Levels& levels);

/// How many there are, without making them.
[[nodiscard]] double levelCount(const Levels& levels);

} // namespace sparkout
