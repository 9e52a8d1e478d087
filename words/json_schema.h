// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <nlohmann/json.hpp>

#include <string>

namespace sparkout {

// Parts of the JSON Schemas of the program's files.

/// Whether a key is required in every file.
[[nodiscard]] bool alwaysRequired(const Field& field);

/// An object with these keys and no others.
[[nodiscard]] nlohmann::ordered_json closedObject(nlohmann::ordered_json properties,
                                                  nlohmann::ordered_json required);

/// A schema that allows null, too.
[[nodiscard]] nlohmann::ordered_json orNull(nlohmann::ordered_json schema);

/// An object as a table describes it: every key with type, range, choices and default.
[[nodiscard]] nlohmann::ordered_json objectSchema(const StructInfo& table);

/// The JSON Schema (draft 2020-12) of a project file of either version, made from the tables: every
/// key with type, range, choices and default, and the unconditional requirements; other keys are
/// not allowed. Only validate() checks rules between values and conditional requirements.
[[nodiscard]] std::string projectSchema();

} // namespace sparkout
