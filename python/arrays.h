// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <vector>

namespace sparkout::python {

using Array = pybind11::array_t<double>;

/// Copies, so that an array outlives what it was made of.
[[nodiscard]] Array arrayOf(const std::vector<double>& values);
/// The same with `columns` values a row.
[[nodiscard]] Array matrixOf(const std::vector<double>& values, std::size_t columns);

/// An array of what a function gives of each item.
template <class Items, class Of>
[[nodiscard]] Array arrayOfEach(const Items& items, Of of) {
    std::vector<double> values;
    values.reserve(items.size());
    for (const auto& item : items) {
        values.push_back(static_cast<double>(of(item)));
    }
    return arrayOf(values);
}

} // namespace sparkout::python
