// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/levels.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

double asWritten(double value) {
    constexpr double decimals = 1e10, lastBits = 1e-9;
    const double written = std::round(value * decimals) / decimals;
    return std::abs(written - value) <= lastBits * std::abs(value) ? written : value;
}

std::vector<double> levelValues(const Levels& levels) {
    if (const auto* list = std::get_if<std::vector<double>>(&levels)) {
        return *list;
    }
    std::vector<double> values;
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        if (stepped->step <= 0) {
            return {stepped->from};
        }
        const double count = std::floor((stepped->to - stepped->from) / stepped->step + 1e-6);
        for (int i = 0; i <= count; ++i) {
            values.push_back(asWritten(stepped->from + i * stepped->step));
        }
    }
    return values;
}

double levelCount(const Levels& levels) {
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels); stepped && stepped->step > 0) {
        return std::max(std::floor((stepped->to - stepped->from) / stepped->step + 1e-6) + 1, 0.0);
    }
    return static_cast<double>(levelValues(levels).size());
}

} // namespace sparkout
