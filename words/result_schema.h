// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <string>

namespace sparkout {

/// The JSON Schema of what `--json` states of results: a definition for each table of outputs, with
/// every key, its type, unit and meaning. Objects may have more keys, which no table describes.
[[nodiscard]] std::string resultSchema();

/// The stubs of the Python module: what is written by hand, where a line "# outputs: remedy" stands
/// for the attributes that this table of the schema has.
[[nodiscard]] std::string resultStubs(const std::string& byHand);

/// "Stepless limit [min]. What it is."
[[nodiscard]] std::string descriptionOf(const OutputRow& row);

} // namespace sparkout
