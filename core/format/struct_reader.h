// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace sparkout {

/// Fills a struct of a file other than a project from a JSON object by its table, and checks it:
/// keys, types, unconditional requirements, and ranges. Keys in `skip` are ignored.
void readStruct(const nlohmann::json& object, const StructInfo& table, void* owner,
                const std::string& path, Issues& issues, const std::vector<std::string>& skip = {});

/// The faults of "format" and "version" of such a file; they decide whether to read the rest.
[[nodiscard]] Issues checkFileHeader(const nlohmann::json& root, const char* format, int newest);

/// Adds an issue unless the list is full.
void addIssue(Issues& issues, Issue issue);

} // namespace sparkout
