// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// Tables of structs as Markdown: a row for each key with its type, unit, default, range and
/// meaning.
class TablePage {
public:
    std::string text;

    /// Adds a struct at its path, and the nested ones.
    void addStruct(const StructInfo& table, const std::string& path);

private:
    void addRow(const Field& field, const StructInfo& table);
    /// A struct with several occurrences is described once.
    void addNested(const StructInfo& table, const std::string& path);

    std::map<const StructInfo*, std::string> m_described;
};

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
