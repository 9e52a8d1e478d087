// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/moments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

// Central moments from the raw ones, m₂ = M₂ − M², m₃ = M₃ − 3·M·M₂ + 2·M³, m₄ = M₄ − 4·M·M₃ +
// 6·M²·M₂ − 3·M⁴. The raw ones are rounded to doubles, each power and each sum: the total error of
// the terms, up to 6·M³ and 14·M⁴, is three units in the last place, which matters where the
// scatter is small relative to the mean.
Moments momentsOf(const ValueStatistics& values) {
    Moments found;
    if (values.count == 0) {
        return found;
    }
    const auto n = static_cast<long double>(values.count);
    const long double M = values.powers[0].value() / n, M2 = values.powers[1].value() / n;
    const long double M3 = values.powers[2].value() / n, M4 = values.powers[3].value() / n;
    found.mean = static_cast<double>(M);
    if (values.least.value == values.most.value) {
        return found;
    }
    const long double m2 = std::max(M2 - M * M, 0.0L);
    if (m2 <= 0) {
        found.skewness = found.excess = std::numeric_limits<double>::quiet_NaN();
        return found;
    }
    found.deviation = static_cast<double>(std::sqrt(m2 * n / (n - 1)));
    const long double s = std::sqrt(m2), size = std::abs(M) / s;
    const auto ifKnown = [](long double value, long double off) {
        constexpr long double most = 1e-3L;
        return off < most ? static_cast<double>(value) : std::numeric_limits<double>::quiet_NaN();
    };
    constexpr long double error = 3 * std::numeric_limits<double>::epsilon();
    found.skewness =
        ifKnown((M3 - 3 * M * M2 + 2 * M * M * M) / (m2 * s), 6 * error * size * size * size);
    found.excess = ifKnown((M4 - 4 * M * M3 + 6 * M * M * M2 - 3 * M * M * M * M) / (m2 * m2) - 3,
                           14 * error * size * size * size * size);
    return found;
}

} // namespace sparkout
