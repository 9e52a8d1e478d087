// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/project_file.h"

#include <nlohmann/json_fwd.hpp>

#include <stop_token>

/// A project as a parsed JSON object: its file without "format" and "version".
namespace sparkout {

inline constexpr const char* projectFormat = "sparkout-project";

/// The faults of "format" and "version", which may be up to `newest`; they decide whether to read
/// the rest.
[[nodiscard]] Issues checkHeader(const nlohmann::json& root, int newest);

/// Reads and validates. Returns all faults at once, after those `found` by parsing; empty after a
/// stop.
[[nodiscard]] ReadResult readProjectJson(const nlohmann::json& root, Issues found,
                                         const std::stop_token& stop);

[[nodiscard]] nlohmann::ordered_json projectJson(const Project& project);

} // namespace sparkout
