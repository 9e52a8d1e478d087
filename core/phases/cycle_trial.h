// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <limits>
#include <optional>
#include <stop_token>

namespace sparkout {

/// Result of a trial of a project's cycle.
struct CycleTrial {
    bool holds = false; ///< it ends by itself and meets every requirement
    double leastMargin =
        -std::numeric_limits<double>::infinity(); ///< relative margin; −∞: the cycle does not end
    double removed_mm3 = 0;                       ///< removed volume, if the cycle ends
};

/// Tries the cycle of a valid project; returns nullopt after a stop.
[[nodiscard]] std::optional<CycleTrial> tried(const Project& project, const std::stop_token& stop);

} // namespace sparkout
