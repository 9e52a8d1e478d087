// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sparkout {

/// The tags that texts of a lesson may have: those of the help's pages that draw or fetch nothing.
/// Formulas stand in `<p class="formula">`, the only attribute there is.
[[nodiscard]] std::span<const char* const> textTags();

/// The first tag of a text that is none of them; nothing: it has none.
[[nodiscard]] std::optional<std::string> foreignTag(std::string_view text);

} // namespace sparkout
