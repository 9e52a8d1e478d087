// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string>

namespace sparkout {

/// The help page of all keys of a project file, Markdown, made from the tables.
[[nodiscard]] std::string referencePage();

/// When a condition holds, in words: "traverse, the stage feeds"; "always"; "never".
/// `table` is that of the struct whose field the condition stands in.
[[nodiscard]] std::string conditionText(Condition condition, const StructInfo& table);

} // namespace sparkout
