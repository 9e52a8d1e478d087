// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/trajectory.h"

#include <QString>

#include <optional>

namespace sparkout::report {

/// One radius under the wheel once: what the hand-out works out.
struct HandoutStep {
    std::size_t pass = 0; ///< index in the trajectory
    int radius = 0;       ///< k
    friend bool operator==(const HandoutStep&, const HandoutStep&) = default;
};

/// Which step is wanted; what is not told may be any.
struct StepWish {
    std::optional<Zone> zone;
    std::optional<int> section, stage, count, step, revolution, radius;
};

/// "27,nz,e1,r1,k9": the double stroke (plunge: the revolution), then in any order a zone or
/// section (rz1, nz, rz2, s0), a stage (z1), a step (e1), a revolution within it (r1), a radius
/// (k9). Nothing for what cannot be read.
[[nodiscard]] std::optional<StepWish> readStepWish(const QString& text);

/// Of the visits that fit the one with the deepest cut, the first of equals. Nothing when none fits
/// or none was recorded.
[[nodiscard]] std::optional<HandoutStep> findStep(const Trajectory& trajectory,
                                                  const StepWish& wish = {});

/// The visit of a step, and that of the same place and radius in another run; null: it has none.
[[nodiscard]] const Visit* visitAt(const Trajectory& trajectory, const HandoutStep& step);
[[nodiscard]] const Visit* sameVisit(const Trajectory& trajectory, const Place& place, int radius);

} // namespace sparkout::report
