// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sparkout {

/// How large a text may be, in one language.
struct TextSize {
    std::size_t bytes = 0;
    std::size_t tags = 0; ///< closing ones included
};

namespace limits {
// What a panel lays out without a noticeable pause.
inline constexpr TextSize lessonTitle{1'000, 20};
inline constexpr TextSize lessonLine{4'000, 80};   ///< the aim, a hint, an option
inline constexpr TextSize lessonText{32'000, 600}; ///< any other text of a lesson
inline constexpr std::size_t lessonTagDepth = 16;  ///< tags within one another
} // namespace limits

/// The tags that texts of a lesson may have: those of the help's pages that draw or fetch nothing.
/// Formulas stand in `<p class="formula">`, the only attribute there is.
[[nodiscard]] std::span<const char* const> textTags();

/// The first tag of a text that is none of them; nothing: it has none.
[[nodiscard]] std::optional<std::string> foreignTag(std::string_view text);

/// The tags of a text without a foreign one: how many, and how many are open at once at most. A
/// paragraph, an entry of a list, a row and a cell end where the next one begins, also without
/// their closing tags.
struct TagCounts {
    std::size_t tags = 0, depth = 0;
};
[[nodiscard]] TagCounts countTags(std::string_view text);

/// Whether a text has known tags alone, and no more of anything than a lesson may have: what may be
/// laid out as markup.
[[nodiscard]] bool isLaidOutSoon(std::string_view text);

} // namespace sparkout
