// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/light.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sparkout {

namespace {

constexpr double leastDivisor = 1e-12; ///< replaces 0 as a divisor

} // namespace

bool isClose(const ConstraintResult& constraint) {
    return constraint.holds && constraint.relativeMargin < closeMargin
           && requirementOf(constraint.kind).scope != ConstraintScope::setting;
}

bool isOpen(const ConstraintResult& constraint) {
    return constraint.holds && constraint.mostValue && *constraint.mostValue > constraint.limit;
}

bool isLowerBound(const ConstraintResult& constraint) {
    return constraint.holds && !constraint.knowsMachine;
}

MarginKnown marginKnown(const ConstraintResult& constraint) {
    if (!constraint.isWhole || isOpen(constraint)) {
        return MarginKnown::no;
    }
    if (!isLowerBound(constraint)) {
        return MarginKnown::exactly;
    }
    const int decimals = requirementOf(constraint.kind).digits.shown;
    return constraint.value < 0.5 * std::pow(10.0, -decimals) ? MarginKnown::no
                                                              : MarginKnown::atMost;
}

double statedMargin(const ConstraintResult& constraint) {
    return constraint.holds && constraint.mostValue ? constraint.limit - *constraint.mostValue
                                                    : constraint.margin;
}

bool isWorse(const ConstraintResult& first, const ConstraintResult& second) {
    const auto rank = [](const ConstraintResult& c) {
        return std::tuple(c.holds, c.holds || c.kind != ConstraintKind::overlap, !c.isWhole,
                          !isClose(c), c.relativeMargin);
    };
    return rank(first) < rank(second);
}

const ConstraintResult* worstRequirement(const std::vector<ConstraintResult>& constraints) {
    const auto worst = std::ranges::min_element(constraints, isWorse);
    return worst == constraints.end() ? nullptr : &*worst;
}

Light lightOf(const ConstraintResult& constraint) {
    if (!constraint.holds) {
        return Light::fails;
    }
    return isOpen(constraint) || isLowerBound(constraint) ? Light::undecided
           : isClose(constraint)                          ? Light::close
                                                          : Light::holds;
}

Light verdictOf(RunStatus status, const std::vector<ConstraintResult>& constraints) {
    Light light = status == RunStatus::completed ? Light::holds : Light::fails;
    for (const ConstraintResult& constraint : constraints) {
        light = std::max(light, lightOf(constraint));
    }
    return light;
}

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

std::optional<double> ratioInRange(const ConstraintResult& requirement) {
    const double limit = requirement.limit, value = requirement.value;
    const bool isRange = requirementOf(requirement.kind).source == LimitSource::range;
    return isRange && limit > 0 && value > 0
               ? std::optional(requirement.isLeast ? value / limit : limit / value)
               : std::nullopt;
}

int digitsOfRatio(double ratio) {
    constexpr int usual = 2, most = 6;
    int digits = usual;
    while (digits < most && ratio != 1 && std::abs(ratio - 1) < std::pow(10, 1 - digits)) {
        ++digits; // until a setting beyond or short of the end differs from it
    }
    return digits;
}

} // namespace sparkout
