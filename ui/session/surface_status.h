// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/quality/constraints.h"
#include "core/setup/wheel_wear.h"

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
    Judgement judgement;          ///< of one that ran
    bool areStocksComing = false; ///< they are being decided
    double time_s = 0;
    std::vector<ConstraintResult> requirements{}; ///< the worst of each kind
    bool isRoughnessEstimate = false;             ///< Ra rests on no calibration
    RemovedMetal removed{};

    [[nodiscard]] bool ran() const { return state == State::ran; }
    [[nodiscard]] bool isCompleted() const { ///< by itself, at size
        return ran() && judgement.status == RunStatus::completed;
    }
    [[nodiscard]] bool holds() const { return ran() && !isFailure(judgement.state); }
};

} // namespace sparkout
