// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/format/project_file.h"

#include <nlohmann/json_fwd.hpp>

#include <stop_token>

/// A project as a parsed JSON object: what stands beside "format" and "version" in its file.
namespace sparkout {

inline constexpr const char* projectFormat = "sparkout-project";

/// What is wrong with "format" and "version", which may be up to `newest`; they decide whether the
/// rest is worth reading.
[[nodiscard]] Issues checkHeader(const nlohmann::json& root, int newest);

/// Reads and validates. All faults at once, after those `found` by parsing; a stop leaves nothing.
[[nodiscard]] ReadResult readProjectJson(const nlohmann::json& root, Issues found,
                                         const std::stop_token& stop);

[[nodiscard]] nlohmann::ordered_json projectJson(const Project& project);

} // namespace sparkout
