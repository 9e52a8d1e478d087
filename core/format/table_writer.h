// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace sparkout {

/// The JSON object of a struct by its table, without keys that are null by default and null, and
/// without those in `skip`.
[[nodiscard]] nlohmann::ordered_json writeByTable(const StructInfo& table, const void* owner,
                                                  const std::vector<std::string>& skip = {});

} // namespace sparkout
