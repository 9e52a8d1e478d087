// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <optional>
#include <string>
#include <string_view>

namespace sparkout {

/// A cell as a number, ignoring spaces around it; empty if it is not a finite number in this
/// dialect.
[[nodiscard]] std::optional<double> cellNumber(std::string_view cell, char decimal);

/// A cell for a message: one line, short.
[[nodiscard]] Quoted quotedCell(std::string_view cell);

/// A text of Latin, Greek and Cyrillic letters in lower case, ё as е.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// The unit that a heading of a table states.
enum class ColumnUnit { none, mm, um, s, ms, min, kw, w, n, kn, a, unknown };

/// The unit named by a text, in English or Russian; empty if it names none.
[[nodiscard]] std::optional<ColumnUnit> unitNamed(std::string_view text);

/// Its first name; empty if it has none.
[[nodiscard]] std::string_view nameOf(ColumnUnit unit);

} // namespace sparkout
