// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/arrays.h"

namespace sparkout::python {

namespace py = pybind11;

Array arrayOf(const std::vector<double>& values) {
    return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

Array matrixOf(const std::vector<double>& values, std::size_t columns) {
    const auto width = static_cast<py::ssize_t>(columns);
    const auto rows =
        columns == 0 ? py::ssize_t{0} : static_cast<py::ssize_t>(values.size() / columns);
    return Array({rows, width}, values.data());
}

} // namespace sparkout::python
