// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/quality/light.h"
#include "core/setup/wheel_wear.h"

#include <optional>
#include <vector>

namespace sparkout {

/// How the cycle of a surface of the set-up stands.
struct SurfaceStatus {
    enum class State {
        notRun,  ///< not yet, or a surface before it cannot be
        refused, ///< its inputs are
        ran
    };
    State state = State::notRun;
    bool isCompleted = false; ///< by itself, at size
    Light light = Light::fails;
    double time_s = 0;
    std::optional<ConstraintResult> worst;        ///< the requirement to speak of first
    std::vector<ConstraintResult> requirements{}; ///< the worst of each kind
    bool isRoughnessEstimate = false;             ///< Ra rests on no calibration
    RemovedMetal removed{};

    [[nodiscard]] bool ran() const { return state == State::ran; }
    [[nodiscard]] bool holds() const { return ran() && isCompleted && light != Light::fails; }
};

} // namespace sparkout
