// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// 0…9, whatever the locale.
[[nodiscard]] constexpr bool isDecimalDigit(char c) {
    return c >= '0' && c <= '9';
}

/// The decimals that give a finite value so many significant digits, at most 9; 0 has one digit
/// before them.
[[nodiscard]] int decimalsOf(double value, int significantDigits);

/// So many decimals, with a point, whatever the locale; never "-0".
[[nodiscard]] std::string fixed(double value, int decimals);

} // namespace sparkout
