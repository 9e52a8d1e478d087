// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// 0…9 in any locale.
[[nodiscard]] constexpr bool isDecimalDigit(char c) {
    return c >= '0' && c <= '9';
}

/// The number of decimals that gives a finite value these significant digits, at most 9; 0 has one
/// digit before them.
[[nodiscard]] int decimalsOf(double value, int significantDigits);

/// This number of decimals, or up to 2 more if another value would otherwise read as the limit.
[[nodiscard]] int decimalsBeside(double limit, double value, int decimals);

/// Formats with this number of decimals and a point in any locale; never "-0".
[[nodiscard]] std::string fixed(double value, int decimals);

/// Formats with as many digits as the value needs, in any locale; with an exponent only below 1e-7
/// and from 1e15 on.
[[nodiscard]] std::string plainNumber(double value);

} // namespace sparkout
