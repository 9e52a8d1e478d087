// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <map>
#include <string>

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

} // namespace sparkout
