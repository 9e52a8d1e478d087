// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// The JSON Schema of what `--json` states of results: a definition for each table of outputs, with
/// every key, its type, unit and meaning. Objects may have more keys, which no table describes.
[[nodiscard]] std::string resultSchema();

} // namespace sparkout
