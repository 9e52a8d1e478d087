// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/thin_out.h"

#include <algorithm>
#include <cstddef>

namespace sparkout {

std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most) {
    const std::size_t count = values.size();
    if (count <= most || most < 4) {
        return {std::move(times), std::move(values)};
    }
    std::vector<std::size_t> kept{0};
    const std::size_t stretches = (most - 2) / 2;
    for (std::size_t i = 0; i < stretches; ++i) {
        const auto begin = static_cast<std::ptrdiff_t>(1 + (count - 2) * i / stretches);
        const auto end = static_cast<std::ptrdiff_t>(1 + (count - 2) * (i + 1) / stretches);
        const auto [least, greatest] =
            std::minmax_element(values.begin() + begin, values.begin() + end);
        auto first = static_cast<std::size_t>(least - values.begin());
        auto second = static_cast<std::size_t>(greatest - values.begin());
        if (second < first) {
            std::swap(first, second);
        }
        kept.push_back(first);
        if (second != first) {
            kept.push_back(second);
        }
    }
    kept.push_back(count - 1);
    std::pair<std::vector<double>, std::vector<double>> thinned;
    thinned.first.reserve(kept.size());
    thinned.second.reserve(kept.size());
    for (const std::size_t index : kept) {
        thinned.first.push_back(times[index]);
        thinned.second.push_back(values[index]);
    }
    return thinned;
}

} // namespace sparkout
