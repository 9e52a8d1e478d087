// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/variant_rules.h"
#include "core/project/number_input.h"

#include <string>
#include <vector>

/// The inputs of a project that a lesson can name, and how the variants vary them.
namespace sparkout {

/// The inputs that the forms show, with those above them: paths in the file.
[[nodiscard]] std::vector<std::string> formInputs(const Project& project);

enum class Puts { numbers, anything };

/// Those that a value can be put into, in the order of the forms.
[[nodiscard]] std::vector<std::string> inputsToPut(const Project& project, Puts puts);

/// The value that an input has in a project; one that it does not have: the path alone.
[[nodiscard]] InputValue valueIn(const Project& project, const std::string& path);

/// How an input is varied, in the order in which the form offers it.
enum class VariedBy { range, list, sets };

[[nodiscard]] VariedBy variedBy(const VariedInput& input);

/// The same levels in another way, as far as it has them; else the value of the project.
[[nodiscard]] VariedInput variedAs(const VariedInput& input, VariedBy by, const Project& project);

/// Variants that the rules have: the product of the levels; 0 where an input has none yet.
[[nodiscard]] double variantCount(const VariantRules& rules);

} // namespace sparkout
