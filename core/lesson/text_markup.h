// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sparkout {

/// The allowed size of a text in one language.
struct TextSize {
    std::size_t bytes = 0;
    std::size_t tags = 0; ///< including closing ones
};

namespace limits {
// The size that a panel lays out without a noticeable pause.
inline constexpr TextSize lessonTitle{1'000, 20};
inline constexpr TextSize lessonLine{4'000, 80};   ///< the aim, a hint, an option
inline constexpr TextSize lessonText{32'000, 600}; ///< any other text of a lesson
inline constexpr std::size_t lessonTagDepth = 16;  ///< tags within one another
} // namespace limits

/// The tags allowed in texts of lessons: those of the help pages that neither draw nor fetch
/// anything. Formulas use `<p class="formula">`, the only attribute.
[[nodiscard]] std::span<const char* const> textTags();

/// The first tag of a text that is not allowed; empty if there is none.
[[nodiscard]] std::optional<std::string> foreignTag(std::string_view text);

/// The number of tags of a text with allowed tags, and their greatest depth. Paragraphs, list
/// entries, rows and cells end where the next one begins, even without closing tags.
struct TagCounts {
    std::size_t tags = 0, depth = 0;
};
[[nodiscard]] TagCounts countTags(std::string_view text);

/// Whether a text has only known tags and is within the sizes of a lesson, so that it may be laid
/// out as markup.
[[nodiscard]] bool isLaidOutSoon(std::string_view text);

} // namespace sparkout
