// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>

#include <functional>
#include <vector>

namespace sparkout {

/// Where a function of a grid is zero, as pieces of lines: within each cell whose four corners have
/// a value the crossings of its edges, linear between the corners, are joined. A cell with a corner
/// that is NaN has none. A saddle is joined by the sign of its middle.
[[nodiscard]] std::vector<QLineF>
zeroLines(const std::vector<double>& across, const std::vector<double>& up,
          const std::function<double(std::size_t i, std::size_t j)>& at);

} // namespace sparkout
