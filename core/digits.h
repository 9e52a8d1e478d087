// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

/// The decimals that give a finite value so many significant digits, at most 9; 0 has one digit
/// before them.
[[nodiscard]] int decimalsOf(double value, int significantDigits);

} // namespace sparkout
