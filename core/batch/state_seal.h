// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The checksum of a batch's state, and bounded parsing of its text.
namespace sparkout {

/// CRC-64 of a text (ECMA-182, reflected): detects accidental damage (except one case in 2^64), not
/// forgery.
[[nodiscard]] std::string checksumOf(std::string_view text);

/// The nesting depth of arrays and objects in a JSON text; undefined for other text. Computed
/// without recursion, so any depth is safe.
[[nodiscard]] std::size_t nestingOf(std::string_view text);

/// Parses a JSON object that nests no deeper than limits::depth, so that recursion over it is safe;
/// empty for any other text.
[[nodiscard]] std::optional<nlohmann::ordered_json> parseState(std::string_view text);

/// The text of a state with its checksum, in place of any it had.
[[nodiscard]] std::string sealed(nlohmann::ordered_json state);

/// Whether the checksum of a state matches the rest of it; removes it.
[[nodiscard]] bool unseal(nlohmann::ordered_json& state);

} // namespace sparkout
