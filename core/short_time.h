// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

namespace sparkout {

/// Times of cycles below it are stated in seconds, as a grinder counts a plunge.
inline constexpr double shortTime_s = 2 * units::secondsPerMinute;

} // namespace sparkout
