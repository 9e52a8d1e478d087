// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/text_markup.h"

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

constexpr std::array allTags{"p",  "i",  "b",    "sub", "sup",   "ul", "ol",
                             "li", "br", "code", "h3",  "table", "tr", "td"};

/// What stands between < and >: a name that is known, after a slash if it closes one.
bool isKnownTag(std::string_view inside) {
    if (inside == "p class=\"formula\"") {
        return true;
    }
    if (inside.starts_with('/')) {
        inside.remove_prefix(1);
    }
    return std::find(allTags.begin(), allTags.end(), inside) != allTags.end();
}

} // namespace

std::span<const char* const> textTags() {
    return allTags;
}

std::optional<std::string> foreignTag(std::string_view text) {
    constexpr std::size_t shown = 40; // bytes
    for (std::size_t at = text.find('<'); at != std::string_view::npos;
         at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos || !isKnownTag(text.substr(at + 1, end - at - 1))) {
            const std::size_t size = end == std::string_view::npos ? shown : end - at + 1;
            return std::string(text.substr(at, std::min(size, shown)));
        }
    }
    return std::nullopt;
}

} // namespace sparkout
