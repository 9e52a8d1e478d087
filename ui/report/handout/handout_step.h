// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/recorded_step.h"

#include <QString>

#include <optional>

namespace sparkout::report {

/// What the hand-out works out.
using HandoutStep = RecordedStep;

/// Which step is wanted; what is not given may be any.
struct StepWish {
    std::optional<Zone> zone;
    std::optional<int> section, stage, count, step, revolution, radius;
};

/// The deepest cut of the roughing stage: what is worked out unless another step is wanted.
[[nodiscard]] inline StepWish usualStep() {
    StepWish wish;
    wish.stage = 1;
    return wish;
}

/// "27,nz,e1,r1,k9": the double stroke (plunge: the revolution), then in any order a zone or
/// section (rz1, nz, rz2, s0), a stage (z1), a step (e1), a revolution within it (r1), a radius
/// (k9). Nothing for what cannot be read.
[[nodiscard]] std::optional<StepWish> readStepWish(const QString& text);

/// Of the visits that fit the one with the deepest cut, the first of equals. Nothing when none fits
/// or none was recorded.
[[nodiscard]] std::optional<HandoutStep> findStep(const Trajectory& trajectory,
                                                  const StepWish& wish = {});

} // namespace sparkout::report
