// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/thin_out.h"

#include <cstddef>

namespace sparkout {

std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most) {
    const std::size_t count = values.size();
    if (count <= most || most == 0) {
        return {std::move(times), std::move(values)};
    }
    std::pair<std::vector<double>, std::vector<double>> thinned;
    for (std::size_t i = 0; i < most; ++i) {
        const std::size_t begin = count * i / most, end = count * (i + 1) / most;
        // Relative to the first, since sums of long times would lose digits.
        double time = 0, value = 0;
        for (std::size_t k = begin; k < end; ++k) {
            time += times[k] - times[begin];
            value += values[k] - values[begin];
        }
        const auto stretch = static_cast<double>(end - begin);
        thinned.first.push_back(times[begin] + time / stretch);
        thinned.second.push_back(values[begin] + value / stretch);
    }
    return thinned;
}

} // namespace sparkout
