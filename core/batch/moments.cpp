// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/moments.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

// Central moments from the raw ones, m₂ = M₂ − M², m₃ = M₃ − 3·M·M₂ + 2·M³,
// m₄ = M₄ − 4·M·M₃ + 6·M²·M₂ − 3·M⁴.
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
        return found;
    }
    found.deviation = static_cast<double>(std::sqrt(m2 * n / (n - 1)));
    found.skewness = static_cast<double>((M3 - 3 * M * M2 + 2 * M * M * M) / (m2 * std::sqrt(m2)));
    found.excess =
        static_cast<double>((M4 - 4 * M * M3 + 6 * M * M * M2 - 3 * M * M * M * M) / (m2 * m2) - 3);
    return found;
}

} // namespace sparkout
