// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_cell.h"

#include "core/printable.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace sparkout {

namespace {

struct UnitName {
    std::string_view text;
    ColumnUnit unit;
};

constexpr auto unitNames = std::to_array<UnitName>({
    {"mm", ColumnUnit::mm},   {"мм", ColumnUnit::mm},   {"um", ColumnUnit::um},
    {"µm", ColumnUnit::um},   {"μm", ColumnUnit::um},   {"мкм", ColumnUnit::um},
    {"s", ColumnUnit::s},     {"sec", ColumnUnit::s},   {"с", ColumnUnit::s},
    {"сек", ColumnUnit::s},   {"ms", ColumnUnit::ms},   {"мс", ColumnUnit::ms},
    {"min", ColumnUnit::min}, {"мин", ColumnUnit::min}, {"kw", ColumnUnit::kw},
    {"квт", ColumnUnit::kw},  {"w", ColumnUnit::w},     {"вт", ColumnUnit::w},
    {"n", ColumnUnit::n},     {"н", ColumnUnit::n},     {"kn", ColumnUnit::kn},
    {"кн", ColumnUnit::kn},   {"a", ColumnUnit::a},     {"а", ColumnUnit::a},
});

} // namespace

std::optional<double> cellNumber(std::string_view cell, char decimal) {
    constexpr std::string_view minus = "\xE2\x88\x92"; // U+2212
    constexpr std::size_t longest = 60;
    std::array<char, longest> digits{};
    std::size_t size = 0;
    cell = trimmed(cell, " \t\r\n");
    if (cell.starts_with(minus)) {
        digits[size++] = '-';
        cell.remove_prefix(minus.size());
    } else if (cell.starts_with('+')) {
        cell.remove_prefix(1);
    }
    if (cell.empty() || cell.size() >= longest - 1) {
        return std::nullopt;
    }
    for (const char c : cell) {
        if (c == ',' || c == '.') {
            if (c != decimal) {
                return std::nullopt;
            }
            digits[size++] = '.';
        } else {
            digits[size++] = c;
        }
    }
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + size, value);
    const bool whole = error == std::errc() && end == digits.data() + size;
    return whole && std::isfinite(value) ? std::optional(value + 0.0) : std::nullopt;
}

Quoted quotedCell(std::string_view cell) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(cell.size(), longest);
    while (end < cell.size() && end > 0
           && (static_cast<unsigned char>(cell[end]) & 0xC0U) == 0x80U) {
        --end; // inside a character
    }
    const char* const rest = end < cell.size() ? "…" : "";
    return {'"' + printable(cell.substr(0, end)) + rest + '"'};
}

std::string lowerCase(std::string_view text) {
    std::string lower;
    lower.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        if (c >= 'A' && c <= 'Z') {
            lower += static_cast<char>(c + ('a' - 'A'));
        } else if (c == 0xD0 && next >= 0x90 && next <= 0x9F) { // А…П
            lower += {'\xD0', static_cast<char>(next + 0x20)};
            ++i;
        } else if (c == 0xD0 && next >= 0xA0 && next <= 0xAF) { // Р…Я
            lower += {'\xD1', static_cast<char>(next - 0x20)};
            ++i;
        } else if ((c == 0xD0 && next == 0x81) || (c == 0xD1 && next == 0x91)) { // Ё and ё are е
            lower += "\xD0\xB5";
            ++i;
        } else {
            lower += text[i];
        }
    }
    return lower;
}

std::optional<ColumnUnit> unitNamed(std::string_view text) {
    const std::string lower = lowerCase(text);
    const auto* const found = std::ranges::find(unitNames, lower, &UnitName::text);
    return found == unitNames.end() ? std::nullopt : std::optional(found->unit);
}

std::string_view nameOf(ColumnUnit unit) {
    const auto* const found = std::ranges::find(unitNames, unit, &UnitName::unit);
    return found == unitNames.end() ? std::string_view() : found->text;
}

} // namespace sparkout
