// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sparkout {

/// At most `most` of the samples of a trace, in their order: the first and the last one, and of as
/// many stretches of equal length as there is room for the least and the greatest value, so that no
/// peak is lost. All of them where they are no more than that.
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most);

} // namespace sparkout
