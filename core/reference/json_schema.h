// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The JSON Schema (draft 2020-12) of a project file of either version, made from the tables: every
/// key with type, range, choices and default, and the unconditional requirements; other keys are
/// not allowed. Only validate() checks rules between values and conditional requirements.
[[nodiscard]] std::string projectSchema();

} // namespace sparkout
