// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

/// The JSON object of a struct by its table, without keys that are null by default and null, and
/// without those in `skip`.
[[nodiscard]] nlohmann::ordered_json writeByTable(const StructInfo& table, const void* owner,
                                                  const std::vector<std::string>& skip = {});

namespace limits {
// Limits of a list whose row allows any number; the excess is not read.
inline constexpr std::size_t listItems = 1'000;     ///< objects, or rows of numbers
inline constexpr std::size_t listNumbers = 100'000; ///< numbers
inline constexpr std::size_t levels = 5'000;        ///< listed levels of a grid
} // namespace limits

/// A key that was not given; whether it is required is known after reading the whole project.
struct MissingKey {
    const Field* field;
    const void* owner;
    std::string path;
};

/// Fills a struct from a JSON object by its table: checks types and keys; validate() checks ranges.
/// Keys in `skip` are ignored.
void readByTable(const nlohmann::json& object, const StructInfo& table, void* owner,
                 const std::string& path, Issues& issues, std::vector<MissingKey>& missing,
                 const std::vector<std::string>& skip = {});

/// Fills a struct of a file other than a project from a JSON object by its table, and checks it:
/// keys, types, unconditional requirements, and ranges. Keys in `skip` are ignored.
void readStruct(const nlohmann::json& object, const StructInfo& table, void* owner,
                const std::string& path, Issues& issues, const std::vector<std::string>& skip = {});

/// The faults of "format" and "version" of such a file; they decide whether to read the rest.
[[nodiscard]] Issues checkFileHeader(const nlohmann::json& root, const char* format, int newest);

/// Adds an issue unless the list is full.
void addIssue(Issues& issues, Issue issue);

} // namespace sparkout
