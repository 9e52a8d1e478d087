// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sparkout {

/// Thins a trace to at most `most` samples: the means of time and value over that many sections of
/// equal length. A record of many thousand values per second has noise whose extremes are far from
/// its mean, which a fit needs. Shorter traces are unchanged.
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most);

} // namespace sparkout
