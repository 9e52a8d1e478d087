// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_statistics.h"

namespace sparkout {

inline constexpr double confidence95 = 0.95;

/// Mean, standard deviation and shape of the values.
struct Moments {
    double mean = 0;
    double deviation = 0; ///< s, with n − 1; 0 of one value
    double skewness = 0;  ///< g₁ = m₃/m₂^1.5; NaN where its error may exceed 0.001
    double excess = 0;    ///< g₂ = m₄/m₂² − 3; NaN if not computable
};
[[nodiscard]] Moments momentsOf(const ValueStatistics& values);

} // namespace sparkout
