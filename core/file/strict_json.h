// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace sparkout {

/// Parses JSON within the limits of project_file.h: UTF-8, no duplicate keys, bounded depth, count
/// and strings. Empty if an issue makes the text unreadable, or after a stop.
[[nodiscard]] std::optional<nlohmann::json> parseStrictly(std::string_view text, Issues& issues,
                                                          const std::stop_token& stop = {});

/// Prints JSON for people: shortest numbers, and arrays or objects that fit on one line.
[[nodiscard]] std::string printJson(const nlohmann::ordered_json& value);

/// A value for a message: one line, short, valid UTF-8.
[[nodiscard]] Detail quoted(const nlohmann::json& value);

/// A key of a file as a step of a JSON pointer, shortened for messages.
[[nodiscard]] std::string pathStep(const std::string& key);

} // namespace sparkout
