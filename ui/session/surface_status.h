// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/quality/constraints.h"
#include "core/setup/wheel_wear.h"

#include <vector>

namespace sparkout {

/// Status of the cycle of a surface of the set-up.
struct SurfaceStatus {
    enum class State {
        notRun,  ///< not run yet, or an earlier surface cannot be run
        refused, ///< its inputs are refused
        ran
    };
    State state = State::notRun;
    Judgement judgement;          ///< judgement of the cycle, if it was run
    bool areStocksComing = false; ///< the stocks are being decided
    double time_s = 0;
    std::vector<ConstraintResult> requirements{}; ///< worst requirement of each kind
    bool isRoughnessEstimate = false;             ///< Ra is not calibrated
    RemovedMetal removed{};

    [[nodiscard]] bool ran() const { return state == State::ran; }
    [[nodiscard]] bool isCompleted() const { ///< whether the cycle ends by itself, at size
        return ran() && judgement.status == RunStatus::completed;
    }
    [[nodiscard]] bool holds() const { return ran() && !isFailure(judgement.state); }
};

} // namespace sparkout
