// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// The help page of all keys of a project file, Markdown, made from the tables.
[[nodiscard]] std::string referencePage();

/// When a condition is true: for each relevant question the answers, to be translated in the
/// context "Condition". Empty: always; nullopt: never.
using ConditionAnswers = std::optional<std::vector<std::vector<const char*>>>;
[[nodiscard]] ConditionAnswers conditionAnswers(Condition condition, const StructInfo& table);

/// The condition as an English text: "traverse, the stage feeds"; "always"; "never". `table` is
/// that of the struct with the field.
[[nodiscard]] std::string conditionText(Condition condition, const StructInfo& table);

} // namespace sparkout
