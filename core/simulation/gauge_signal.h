// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// Added to every threshold, so that a last bit costs no step [mm].
inline constexpr double stageSlack_mm = 1e-9;

/// A reading counts as so much older, so that a last bit of a time costs no step [s].
inline constexpr double delaySlack_s = 1e-9;

/// The gauge's readings in a cycle, and what the control makes of them [MODEL-7]. It learns of each
/// the gauge's delay τ_g after it was taken, and after the machine's feed change delay τ_f more the
/// feed is that of the next stage. So a step that ends at t is the last one of a stage when
///
///     a reading taken at t_m, t_m + τ_g + τ_f ≤ t, shows that no more than the later stocks is
///     left, or one with t_m + τ_g ≤ t that the size is reached,
///
/// and the last one of the cycle in the second case alone, for drawing the wheel back is no change
/// of feed. A stage so goes on for ⌈τ/T⌉ steps of the time T beyond the one whose reading ends it;
/// without delays it ends with that one.
class GaugeSignal {
public:
    /// Of a project's gauge and machine; `endsCycle`: the last stage is ended by the gauge, not by
    /// a number of spark-outs.
    GaugeSignal(const Project& project, bool endsCycle);

    /// After a step, at rising times.
    void read(double time_s, double remaining_mm);
    /// Whether a stage with so much stock behind it is over, the last of the cycle or another one.
    [[nodiscard]] bool isOver(double later_mm, bool last) const {
        return overBy(later_mm, last) >= 0;
    }
    /// How much more all readings may show [mm] for it to be over still.
    [[nodiscard]] double overBy(double later_mm, bool last) const;
    /// The same for the last reading to end a stage, at once or when the delay is over.
    [[nodiscard]] double dueBy(double later_mm) const { return knownBy(later_mm, 0); }

private:
    struct Reading {
        double time_s = 0, remaining_mm = 0;
    };
    [[nodiscard]] double knownBy(double least_mm, double delay_s) const;

    double m_end_s = 0;    ///< from a reading to the end of the cycle
    double m_change_s = 0; ///< and to the feed of the next stage
    bool m_endsCycle = false;
    std::vector<Reading> m_readings; ///< that may count still, the oldest first
};

} // namespace sparkout
