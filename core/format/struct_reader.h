// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace sparkout {

/// Fills a struct of a file that is no project from a JSON object by its table, and holds it
/// against the table: keys, types, what is required always, and ranges. Keys named in `skip` are
/// somebody else's.
void readStruct(const nlohmann::json& object, const StructInfo& table, void* owner,
                const std::string& path, Issues& issues, const std::vector<std::string>& skip = {});

/// What is wrong with "format" and "version" of such a file; they decide whether the rest is worth
/// reading.
[[nodiscard]] Issues checkFileHeader(const nlohmann::json& root, const char* format, int newest);

/// Adds an issue unless as many are listed already as are listed at most.
void addIssue(Issues& issues, Issue issue);

} // namespace sparkout
