// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

/// Marks a text of the core for translation (lupdate reads it as QT_TRANSLATE_NOOP); the window
/// translates it in the same context, the command line prints it untranslated.
#define SPARKOUT_NOOP(context, text) text

namespace sparkout {

/// The text without characters of `around` at its ends.
[[nodiscard]] constexpr std::string_view trimmed(std::string_view text, std::string_view around) {
    const std::size_t first = text.find_first_not_of(around);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(around) - first + 1);
}

} // namespace sparkout
