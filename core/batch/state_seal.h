// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The checksum of a batch's state, and its text taken in within bounds.
namespace sparkout {

/// CRC-64 of a text (ECMA-182, reflected): against accidents (it misses one in 2^64), not against a
/// forger.
[[nodiscard]] std::string checksumOf(std::string_view text);

/// How deep arrays and objects stand in each other in a JSON text; of another text no matter what.
/// Walked without recursion, so a text of any depth can be asked.
[[nodiscard]] std::size_t nestingOf(std::string_view text);

/// An object of JSON that nests no deeper than limits::depth, below which everything here may walk
/// it by recursion; nothing of another text.
[[nodiscard]] std::optional<nlohmann::ordered_json> parseState(std::string_view text);

/// The text of a state with the checksum that belongs to it, in place of any it had.
[[nodiscard]] std::string sealed(nlohmann::ordered_json state);

/// Whether the checksum of a state fits the rest of it; takes it out.
[[nodiscard]] bool unseal(nlohmann::ordered_json& state);

} // namespace sparkout
