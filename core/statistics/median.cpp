// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/median.h"

#include <algorithm>
#include <cstddef>

namespace sparkout {

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace sparkout
