// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// The help page of all keys of a project file, Markdown, made from the tables.
[[nodiscard]] std::string referencePage();

/// When a condition holds: of each question that matters the answers for which it does, to be
/// translated in the context "Condition". Empty: always; none: never.
using ConditionAnswers = std::optional<std::vector<std::vector<const char*>>>;
[[nodiscard]] ConditionAnswers conditionAnswers(Condition condition, const StructInfo& table);

/// The same as a text, in English: "traverse, the stage feeds"; "always"; "never".
/// `table` is that of the struct whose field the condition stands in.
[[nodiscard]] std::string conditionText(Condition condition, const StructInfo& table);

} // namespace sparkout
