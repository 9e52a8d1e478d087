// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/output_attributes.h"

#include <type_traits>

namespace sparkout::python {

namespace py = pybind11;

py::object fromJson(const std::string& text) {
    return py::module_::import("json").attr("loads")(text);
}

py::object outputObject(const OutputValue& value) {
    return std::visit(
        [](const auto& of) -> py::object {
            using Value = std::decay_t<decltype(of)>;
            if constexpr (std::is_same_v<Value, std::monostate>) {
                return py::none();
            } else if constexpr (std::is_same_v<Value, Interval>) {
                return py::make_tuple(of.low, of.high);
            } else if constexpr (std::is_same_v<Value, Estimate>) {
                return py::make_tuple(of.value, outputObject(of.interval));
            } else if constexpr (std::is_same_v<Value, Share>) {
                return py::make_tuple(of.count, of.value,
                                      of.interval ? outputObject(*of.interval) : py::none());
            } else {
                return py::cast(of);
            }
        },
        value);
}

} // namespace sparkout::python
