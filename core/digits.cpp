// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/digits.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

int decimalsOf(double value, int significantDigits) {
    const double size = std::abs(value);
    const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
    return std::clamp(significantDigits - before, 0, 9);
}

} // namespace sparkout
