// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// Tolerance added to every threshold, so that rounding does not cost a step [mm].
inline constexpr double stageSlack_mm = 1e-9;

/// Tolerance added to the age of a reading, so that rounding does not cost a step [s].
inline constexpr double delaySlack_s = 1e-9;

/// The gauge's readings in a cycle and their evaluation by the control [MODEL-7]. The control
/// receives each reading the gauge's delay τ_g after it was taken; the machine's feed change delay
/// τ_f later the feed is that of the next stage. A step that ends at t is therefore the last one of
/// a stage when
///
///     a reading taken at t_m, t_m + τ_g + τ_f ≤ t, shows that no more than the later stocks is
///     left, or one with t_m + τ_g ≤ t that the size is reached,
///
/// and the last one of the cycle only in the second case, because drawing the wheel back is not a
/// change of feed. A stage therefore continues for ⌈τ/T⌉ steps of the time T after the one whose
/// reading ends it; without delays it ends with that one.
class GaugeSignal {
public:
    /// Takes the delays of a project's gauge and machine; `endsCycle`: the gauge ends the last
    /// stage, not a number of spark-out steps.
    GaugeSignal(const Project& project, bool endsCycle);

    /// Takes the reading after a step; times must rise.
    void read(double time_s, double remaining_mm);
    /// Returns whether a stage with this stock of the later stages is finished; `last`: it is the
    /// last stage of the cycle.
    [[nodiscard]] bool isOver(double later_mm, bool last) const {
        return overBy(later_mm, last) >= 0;
    }
    /// Returns by how much all readings may be greater [mm] without changing that the stage is
    /// finished.
    [[nodiscard]] double overBy(double later_mm, bool last) const;
    /// Like overBy(), for the last reading to end a stage at once or after the delay.
    [[nodiscard]] double dueBy(double later_mm) const { return knownBy(later_mm, 0); }

private:
    struct Reading {
        double time_s = 0, remaining_mm = 0;
    };
    [[nodiscard]] double knownBy(double least_mm, double delay_s) const;

    double m_end_s = 0;    ///< delay from a reading to the end of the cycle
    double m_change_s = 0; ///< delay from a reading to the feed of the next stage
    bool m_endsCycle = false;
    std::vector<Reading> m_readings; ///< readings that may still count, the oldest first
};

} // namespace sparkout
