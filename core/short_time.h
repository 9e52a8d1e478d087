// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

namespace sparkout {

/// Shorter cycle times are stated in seconds, as grinders count a plunge.
inline constexpr double shortTime_s = 2 * units::secondsPerMinute;

/// The common unit of times shown together, in seconds, by the longest of them.
[[nodiscard]] constexpr double timeUnit_s(double longest_s) {
    return longest_s < shortTime_s ? 1 : units::secondsPerMinute;
}

} // namespace sparkout
