// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/result_schema.h"

#include <pybind11/pybind11.h>

#include <functional>
#include <span>
#include <string>

namespace sparkout::python {

/// The objects of a text of JSON.
[[nodiscard]] pybind11::object fromJson(const std::string& text);

/// None where there is no value, an interval as a tuple.
[[nodiscard]] pybind11::object outputObject(const OutputValue& value);

/// A read-only attribute for each output that has a key; `ownerOf` takes what the outputs are of
/// from what Python holds.
template <class Type, class Owner, class OwnerOf = std::identity>
void bindOutputs(Type& type, std::span<const Output<Owner>> rows, OwnerOf ownerOf = {}) {
    for (const Output<Owner>& row : rows) {
        if (*row.key) {
            type.def_property_readonly(
                row.key,
                [&row, ownerOf](const typename Type::type& self) {
                    const Owner& owner = std::invoke(ownerOf, self);
                    return outputObject(row.isStated(owner) ? row.of(owner) : OutputValue());
                },
                descriptionOf(row).c_str());
        }
    }
}

/// Adds an item to a dict for each output that JSON states.
template <class Owner>
void addOutputs(pybind11::dict& dict, std::span<const Output<Owner>> rows, const Owner& owner) {
    for (const Output<Owner>& row : rows) {
        if (*row.key && row.isStated(owner)) {
            dict[row.key] = outputObject(row.of(owner));
        }
    }
}

} // namespace sparkout::python
