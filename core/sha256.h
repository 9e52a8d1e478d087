// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sparkout {

/// SHA-256 of these bytes [FIPS180-4], 64 hexadecimal digits, by which a source is recognised.
[[nodiscard]] std::string sha256(std::string_view bytes);

} // namespace sparkout
