// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/usage.h"

#include "core/quality/light.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {
constexpr double leastDivisor = 1e-12; ///< replaces 0 as a divisor
} // namespace

double usageOf(const ConstraintResult& requirement) {
    const double limit = requirement.limit, value = requirement.value;
    if (requirementOf(requirement.kind).scope == ConstraintScope::setting) {
        return requirement.isLeast ? std::max(limit, 0.0) / std::max(value, leastDivisor)
                                   : value / std::max(limit, leastDivisor);
    }
    const bool isDecidedEstimate = requirement.mostValue && lightOf(requirement) == Light::holds;
    return isDecidedEstimate ? *requirement.mostValue / limit
                             : std::max(1 - requirement.relativeMargin, 0.0);
}

std::optional<double> placeInRange(const ConstraintResult& requirement) {
    if (!requirement.otherEnd) {
        return std::nullopt;
    }
    const auto [low, high] = std::minmax(requirement.limit, *requirement.otherEnd);
    const double value = std::clamp(requirement.value, low, high);
    if (high <= low) {
        return 0.5;
    }
    return low > 0 ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

} // namespace sparkout
