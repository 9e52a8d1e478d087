// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/variant_rules.h"
#include "core/project/number_input.h"

#include <string>
#include <vector>

/// The inputs that a lesson can refer to, and their variation.
namespace sparkout {

/// The inputs shown in the forms, and those above them: paths in the file.
[[nodiscard]] std::vector<std::string> formInputs(const Project& project);

enum class Puts { numbers, anything };

/// The inputs to which a value can be assigned, in the order of the forms.
[[nodiscard]] std::vector<std::string> inputsToPut(const Project& project, Puts puts);

/// The value of an input in a project; only the path if it has none.
[[nodiscard]] InputValue valueIn(const Project& project, const std::string& path);

/// The kind of variation of an input, in the order of the form.
enum class VariedBy { range, list, sets };

[[nodiscard]] VariedBy variedBy(const VariedInput& input);

/// Converts to the same levels in another form, as far as possible; otherwise uses the project's
/// value.
[[nodiscard]] VariedInput variedAs(const VariedInput& input, VariedBy by, const Project& project);

/// The number of variants of the rules: the product of the levels; 0 if an input has none yet.
[[nodiscard]] double variantCount(const VariantRules& rules);

} // namespace sparkout
