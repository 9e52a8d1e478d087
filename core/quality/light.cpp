// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/light.h"

#include <algorithm>

namespace sparkout {

Light lightOf(const ConstraintResult& constraint) {
    if (!constraint.holds) {
        return Light::fails;
    }
    const bool close = constraint.relativeMargin < closeMargin
                       && requirementOf(constraint.kind).scope != ConstraintScope::setting;
    return close ? Light::close : Light::holds;
}

Light verdictOf(RunStatus status, const std::vector<ConstraintResult>& constraints) {
    Light light = status == RunStatus::completed ? Light::holds : Light::fails;
    for (const ConstraintResult& constraint : constraints) {
        light = std::max(light, lightOf(constraint));
    }
    return light;
}

} // namespace sparkout
