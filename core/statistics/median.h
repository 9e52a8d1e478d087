// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace sparkout {

/// Ratio of a normal distribution's standard deviation to the median of its absolute values.
inline constexpr double deviationPerMedian = 1.482602218505602;

/// The upper median of at least one value.
[[nodiscard]] double medianOf(std::vector<double> values);

} // namespace sparkout
