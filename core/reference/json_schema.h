// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The JSON Schema (draft 2020-12) of a project file of either version, made from the tables: every
/// key with type, range, choices and default; what is required always; nothing else allowed. The
/// rules between values, and what is required only sometimes, are validate()'s alone.
[[nodiscard]] std::string projectSchema();

} // namespace sparkout
