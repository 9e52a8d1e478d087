// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/catalogue/shipped_catalogue.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <type_traits>
#include <utility>

namespace sparkout {

namespace {

template <class Entry>
constexpr const char* catalogueKind() {
    return std::is_same_v<Entry, MaterialEntry> ? "materials"
           : std::is_same_v<Entry, WheelEntry>  ? "wheels"
                                                : "machines";
}

/// Letters that look alike, and their common form.
constexpr std::array<std::pair<std::string_view, char>, 24> alikeLetters{
    {{"А", 'a'}, {"В", 'b'}, {"Е", 'e'}, {"К", 'k'}, {"М", 'm'}, {"Н", 'h'},
     {"О", 'o'}, {"Р", 'p'}, {"С", 'c'}, {"Т", 't'}, {"Х", 'x'}, {"У", 'y'},
     {"а", 'a'}, {"в", 'b'}, {"е", 'e'}, {"к", 'k'}, {"м", 'm'}, {"н", 'h'},
     {"о", 'o'}, {"р", 'p'}, {"с", 'c'}, {"т", 't'}, {"х", 'x'}, {"×", 'x'}}};

/// The form of a name for comparison.
std::string comparable(std::string_view text) {
    std::string letters;
    while (!text.empty()) {
        const auto* const alike = std::ranges::find_if(
            alikeLetters, [&](const auto& each) { return text.starts_with(each.first); });
        if (alike != alikeLetters.end()) {
            letters += alike->second;
            text.remove_prefix(alike->first.size());
            continue;
        }
        const char c = text.front();
        if (c != ' ') {
            letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
        text.remove_prefix(1);
    }
    return letters;
}

} // namespace

template <class Entry>
const std::vector<Entry>& shippedEntries() {
    static const std::vector<Entry> entries = [] {
        auto read = readCatalogue<Entry>(shippedCatalogueText(catalogueKind<Entry>()));
        assert(read.entries); // checked by a test
        return std::move(read.entries).value_or(std::vector<Entry>());
    }();
    return entries;
}

template <class Entry>
std::vector<const Entry*> entriesMeant(const std::vector<Entry>& entries, std::string_view text) {
    const std::string wanted = comparable(text);
    std::vector<const Entry*> parts;
    for (const Entry& entry : entries) {
        const std::string name = comparable(entry.name);
        if (name == wanted) {
            return {&entry};
        }
        if (!wanted.empty() && name.find(wanted) != std::string::npos) {
            parts.push_back(&entry);
        }
    }
    return parts;
}

template <class Entry>
const Entry* entryMeant(const std::vector<Entry>& entries, std::string_view text) {
    const std::vector<const Entry*> meant = entriesMeant(entries, text);
    return meant.size() == 1 ? meant.front() : nullptr;
}

#define SPARKOUT_SHIPPED(Entry)                                                                    \
    template const std::vector<Entry>& shippedEntries<Entry>();                                    \
    template std::vector<const Entry*> entriesMeant<Entry>(const std::vector<Entry>&,              \
                                                           std::string_view);                      \
    template const Entry* entryMeant<Entry>(const std::vector<Entry>&, std::string_view)
SPARKOUT_SHIPPED(MaterialEntry);
SPARKOUT_SHIPPED(WheelEntry);
SPARKOUT_SHIPPED(MachineEntry);
#undef SPARKOUT_SHIPPED

} // namespace sparkout
