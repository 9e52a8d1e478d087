// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>

namespace sparkout {

struct Project;
struct Setup;

/// A value that a lesson puts into a project: a number, or a text for a choice or a name.
struct InputValue {
    std::string path; ///< path of the input, "/wheel/dullness"
    std::optional<double> number;
    std::string text; ///< used without a number
    friend bool operator==(const InputValue&, const InputValue&) = default;
};

/// Sets an input; false if the project has none that takes the value.
[[nodiscard]] bool putInput(Project& project, const InputValue& value);

/// Sets an input in a surface of a set-up, or in all of them if they share it.
[[nodiscard]] bool putInput(Setup& setup, std::size_t surface, const InputValue& value);

template <>
const StructInfo& tableOf<InputValue>();

} // namespace sparkout
