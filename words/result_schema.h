// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <string>

namespace sparkout {

/// The JSON Schema of the results of `--json`: a definition for each table of outputs, with every
/// key, its type, unit and meaning. Objects may have additional keys that no table describes.
[[nodiscard]] std::string resultSchema();

/// The stubs of the Python module: the manual part, in which a line "# outputs: remedy" is replaced
/// by the attributes of that table of the schema, "# items: zone" by the items of a dict.
[[nodiscard]] std::string resultStubs(const std::string& byHand);

/// "Stepless limit [min]. Its meaning."
[[nodiscard]] std::string descriptionOf(const OutputRow& row);

} // namespace sparkout
