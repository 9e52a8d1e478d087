// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/digits.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sparkout {

int decimalsOf(double value, int significantDigits) {
    const double size = std::abs(value);
    const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
    return std::clamp(significantDigits - before, 0, 9);
}

int decimalsBeside(double limit, double value, int decimals) {
    constexpr int more = 2;
    int needed = decimals;
    while (needed < decimals + more && value != limit
           && fixed(value, needed) == fixed(limit, needed)) {
        ++needed;
    }
    return needed;
}

std::string fixed(double value, int decimals) {
    const double least = 0.5 * std::pow(10.0, -decimals);
    char buffer[400]; // the largest double has 309 digits before the point
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, std::abs(value) < least ? 0.0 : value,
                      std::chars_format::fixed, decimals);
    return {buffer, end};
}

std::string plainNumber(double value) {
    constexpr double smallestPlain = 1e-7, largestPlain = 1e15;
    const double size = std::abs(value);
    char buffer[64];
    const auto [end, error] =
        size == 0 || (size >= smallestPlain && size < largestPlain)
            ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed)
            : std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end};
}

} // namespace sparkout
