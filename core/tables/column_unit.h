// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace sparkout {

/// The unit that a heading of a table states.
enum class ColumnUnit { none, mm, um, s, ms, min, kw, w, n, kn, a, unknown };

/// The unit named by a text, in English or Russian; empty if it names none.
[[nodiscard]] std::optional<ColumnUnit> unitNamed(std::string_view text);

/// Its first name; empty if it has none.
[[nodiscard]] std::string_view nameOf(ColumnUnit unit);

} // namespace sparkout
