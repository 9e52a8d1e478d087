// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/natural_order.h"

#include <algorithm>
#include <cstddef>

namespace sparkout {

namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t digitsFrom(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end]))
        ++end;
    return end - at;
}

int valueAt(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

} // namespace

int naturalOrder(std::string_view a, std::string_view b) {
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const auto at = static_cast<std::size_t>(differ.first - a.begin());
    if (at == a.size() && at == b.size())
        return 0;
    std::size_t begin = at; // start of the number in which they differ
    while (begin > 0 && isDigit(a[begin - 1]))
        --begin;
    const int byLetter = valueAt(a, at) - valueAt(b, at);
    const std::size_t longA = digitsFrom(a, at), longB = digitsFrom(b, at);
    const bool decimals = valueAt(a, begin) == '0' || valueAt(b, begin) == '0';
    if (!decimals) {
        // Both are numbers, or become numbers here: the longer one is greater.
        const bool numbers = digitsFrom(a, begin) > 0 && digitsFrom(b, begin) > 0;
        return numbers && longA != longB ? (longA > longB ? 1 : -1) : byLetter;
    }
    // After zeros only, more digits precede none: 00 < 0.
    const bool zerosOnly = a.substr(begin, at - begin).find_first_not_of('0') == a.npos;
    if (begin < at && zerosOnly && (longA > 0) != (longB > 0))
        return longA > 0 ? -1 : 1;
    return byLetter;
}

} // namespace sparkout
