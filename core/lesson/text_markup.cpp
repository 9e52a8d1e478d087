// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/text_markup.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace sparkout {

namespace {

constexpr std::array allTags{"p",  "i",  "b",    "sub", "sup",   "ul", "ol",
                             "li", "br", "code", "h3",  "table", "tr", "td"};
constexpr std::string_view formulaTag = "p class=\"formula\"";

/// Whether the text between < and > is a known tag, after a slash if it closes one.
bool isKnownTag(std::string_view inside) {
    if (inside == formulaTag) {
        return true;
    }
    if (inside.starts_with('/')) {
        inside.remove_prefix(1);
    }
    return std::find(allTags.begin(), allTags.end(), inside) != allTags.end();
}

/// Calls a function with the text between each < and the following > (empty without one) and with
/// the position of the <, while the function returns true.
template <typename Visit>
void eachTag(std::string_view text, Visit&& visit) {
    for (std::size_t at = text.find('<'); at != std::string_view::npos;
         at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        const bool isClosed = end != std::string_view::npos;
        if (!visit(isClosed ? std::optional(text.substr(at + 1, end - at - 1)) : std::nullopt,
                   at)) {
            return;
        }
    }
}

/// The tags that are open at a place of a text.
class OpenTags {
public:
    [[nodiscard]] std::size_t depth() const { return m_open.size(); }

    void open(std::string_view name) {
        if (name == "br") {
            return;
        }
        if (name == "p" || name == "li" || name == "tr" || name == "td") {
            end(name, isStructure); // ends implicitly, but not beyond its table or list
        }
        m_open.push_back(name);
    }
    /// Closes the innermost tag with the name and all tags inside it.
    void close(std::string_view name) {
        end(name, [](std::string_view) { return false; });
    }

private:
    static bool isStructure(std::string_view name) {
        return name == "table" || name == "ul" || name == "ol";
    }
    template <typename IsBorder>
    void end(std::string_view name, IsBorder isBorder) {
        const auto found = std::find_if(m_open.rbegin(), m_open.rend(), [&](std::string_view each) {
            return each == name || isBorder(each);
        });
        if (found != m_open.rend() && *found == name) {
            m_open.erase(std::prev(found.base()), m_open.end());
        }
    }

    std::vector<std::string_view> m_open;
};

} // namespace

std::span<const char* const> textTags() {
    return allTags;
}

std::optional<std::string> foreignTag(std::string_view text) {
    constexpr std::size_t shown = 40; // bytes
    std::optional<std::string> foreign;
    eachTag(text, [&](const std::optional<std::string_view>& inside, std::size_t at) {
        if (!inside || !isKnownTag(*inside)) {
            foreign = text.substr(at, inside ? std::min(inside->size() + 2, shown) : shown);
        }
        return !foreign;
    });
    return foreign;
}

TagCounts countTags(std::string_view text) {
    TagCounts counts;
    OpenTags open;
    eachTag(text, [&](const std::optional<std::string_view>& inside, std::size_t) {
        ++counts.tags;
        const std::string_view name = inside == formulaTag ? "p" : inside.value_or("");
        if (name.starts_with('/')) {
            open.close(name.substr(1));
        } else {
            open.open(name);
        }
        counts.depth = std::max(counts.depth, open.depth());
        return true;
    });
    return counts;
}

bool isLaidOutSoon(std::string_view text) {
    if (text.size() > limits::lessonText.bytes || foreignTag(text)) {
        return false;
    }
    const TagCounts counts = countTags(text);
    return counts.tags <= limits::lessonText.tags && counts.depth <= limits::lessonTagDepth;
}

} // namespace sparkout
