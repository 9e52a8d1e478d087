// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <limits>
#include <optional>
#include <stop_token>

namespace sparkout {

/// How the cycle of a valid project does.
struct CycleTrial {
    bool holds = false; ///< it ends by itself, and every requirement holds
    double leastMargin = -std::numeric_limits<double>::infinity(); ///< relative; if it ends
    double removed_mm3 = 0;                                        ///< if it ends
};

/// Nothing: it was stopped, so nothing is known.
[[nodiscard]] std::optional<CycleTrial> tried(const Project& project, const std::stop_token& stop);

} // namespace sparkout
