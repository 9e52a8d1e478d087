// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sparkout {

/// A trace of at most `most` samples: the means of time and value of as many stretches of equal
/// length. A record of many thousand values a second has noise whose least and greatest values are
/// far from its mean, and a fit is about the mean. All of them where they are no more than that.
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most);

} // namespace sparkout
