// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>

namespace sparkout {

struct Project;
struct Setup;

/// A value that a lesson puts into a project: a number, or the text of a choice or of a name.
struct InputValue {
    std::string path; ///< of an input, "/wheel/dullness"
    std::optional<double> number;
    std::string text; ///< where there is no number
    friend bool operator==(const InputValue&, const InputValue&) = default;
};

/// Puts a value in its place; false: the project has no such input, or none that takes it.
[[nodiscard]] bool putInput(Project& project, const InputValue& value);

/// The same in a surface of a set-up, in all of them where they share it.
[[nodiscard]] bool putInput(Setup& setup, std::size_t surface, const InputValue& value);

template <>
const StructInfo& tableOf<InputValue>();

} // namespace sparkout
