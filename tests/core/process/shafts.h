// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/compliance.h"

#include <cmath>
#include <limits>
#include <numbers>

/// Shafts of steel on springs.
namespace sparkout::shafts {

inline constexpr double rigid = std::numeric_limits<double>::infinity();
inline constexpr double E = 2.1e5;

inline double I(double d) {
    return std::numbers::pi * std::pow(d, 4) / 64;
}

inline ShaftModel uniform(double L, double d, Mounting mounting, double jh, double jt, double jw) {
    return {{{L, d}}, E, mounting, jh, jt, jw, {}};
}

} // namespace sparkout::shafts
