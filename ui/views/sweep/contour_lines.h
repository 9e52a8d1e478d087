// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>

#include <functional>
#include <vector>

namespace sparkout {

/// The zero lines of a function on a grid, as line segments: within each cell with four finite
/// corners, the zeros on its edges, interpolated linearly, are joined. A cell with a NaN corner has
/// none. The sign of the middle decides how a saddle is joined.
[[nodiscard]] std::vector<QLineF>
zeroLines(const std::vector<double>& across, const std::vector<double>& up,
          const std::function<double(std::size_t i, std::size_t j)>& at);

} // namespace sparkout
