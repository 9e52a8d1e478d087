// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

[[nodiscard]] std::string today(); ///< today's date, UTC: "2026-03-05"

} // namespace sparkout
