// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/project.h"

#include <cstddef>
#include <span>
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
    /// Returns the remaining stock by which the control changes the feed [mm]: that of the newest
    /// reading older than both delays; infinite if there is none.
    [[nodiscard]] double known_mm() const { return stageSlack_mm - knownBy(0, m_change_s); }

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

/// Returns the number of steps of this time [s] by which a stage that the gauge ends continues
/// until the feed changes; 0 under position control.
[[nodiscard]] int lateSteps(const Project& project, double step_s);

/// Returns the infeed per step of each stage of the project's cycle [mm]; 0 where none is set.
[[nodiscard]] std::vector<double> infeedsOfStages(const Project& project);
/// Returns the greatest infeed of a step of each stage [mm]: its radial infeed, and the continuous
/// infeed S_c during the longest of its double strokes.
[[nodiscard]] std::vector<double> fedByStep_mm(const Project& project);

/// Determines the next infeed and the end of each stage of the cycle [MODEL-7]. One step is a
/// double stroke (traverse) or a revolution (plunge).
class StageControl {
public:
    /// `feeds_mm` is each stage's infeed per step; `totalInfeed_mm` = |R_first − R_t|.
    StageControl(const Project& project, std::vector<double> feeds_mm, double totalInfeed_mm);

    [[nodiscard]] bool finished() const { return m_stage == m_feeds.size(); }
    /// The running stage, counted from 0.
    [[nodiscard]] std::size_t stage() const { return m_stage; }
    /// Returns the infeed of the next step [mm] at t_П = `fed_mm`: none in a spark-out stage, cut
    /// short at the stage's end under position control.
    [[nodiscard]] double nextInfeed(double fed_mm) const;
    /// Returns the t_П at which a continuous infeed stops [mm]: under position control the stage's
    /// end.
    [[nodiscard]] double mostFed() const;
    /// Returns whether the running stage waits for size without feeding, so that it may wait
    /// forever.
    [[nodiscard]] bool waitsForSize() const;
    /// Returns whether the running stage retracts the wheel head (negative feed): it then cuts by
    /// the stored deflection. It ends like any other stage, or when nothing is cut any more; this
    /// is an option beyond the sources [MODEL-7].
    [[nodiscard]] bool retracts() const;
    /// Ends the running stage, which is over or is a retraction that has lost contact.
    void endStage() { ++m_stage; }
    /// Records a step that ends at this time, and ends finished stages. One reading may end
    /// several.
    void stepDone(double remainingStock_mm, double fed_mm, double time_s);
    /// Records a step without ending stages.
    void read(double remainingStock_mm, double time_s);
    /// Returns by how much the stock may be larger [mm] with the running stage still ending at this
    /// step: it ends if this is not negative. Infinite if the stock does not decide.
    [[nodiscard]] double overBy(double fed_mm) const;
    /// Like overBy(), for a stage that only waits until the control receives the reading that ends
    /// it.
    [[nodiscard]] double dueBy() const { return m_gauge.dueBy(m_laterStock[m_stage]); }

    [[nodiscard]] const std::vector<int>& stepsByStage() const { return m_steps; }

private:
    [[nodiscard]] double stageEndInfeed() const;

    std::vector<double> m_feeds;
    std::vector<Stage> m_stages;
    std::vector<double> m_laterStock; ///< Σ_{j>z} Π_j
    std::vector<int> m_steps;
    Control m_control;
    double m_fedAtSize_mm;
    GaugeSignal m_gauge;
    std::size_t m_stage = 0;
};

/// Returns the remaining stock per side Π_rem [mm] that the gauge reads on one section, from the
/// depths of its radii, D_k = R_k + R_{k+K/2}, the gauge's rule and the depth at which it reads the
/// size; mirrored in a bore.
[[nodiscard]] double remainingStock(const double* depth_mm, int radii, GaugeRule rule,
                                    double sizeDepth_mm);

/// Returns the remaining stock by only the diameters with these k, at least one, which no gap
/// interrupts.
[[nodiscard]] double remainingStock(const double* depth_mm, int radii,
                                    std::span<const std::size_t> diameters, GaugeRule rule,
                                    double sizeDepth_mm);

/// Returns w under position control [mm]: the head is where it would be with a new wheel, so the
/// worn wheel's surface is that much farther from the part [MODEL-7]. Under gauge control it is 0,
/// because feeding starts at the touch and ends by the reading.
[[nodiscard]] double standsBack_mm(const Project& project);

/// Returns the depth below first touch at which a cycle that ends by itself leaves a radius [mm]:
/// |R_first − R_t|, under gauge control plus half of the gauge's excess reading.
[[nodiscard]] double depthAtEnd_mm(const Project& project, double totalInfeed_mm);

/// Returns the t_П at which position control assumes the part to be at size [mm]: |R_first − R_t| −
/// w.
[[nodiscard]] double fedAtSize(const Project& project, double totalInfeed_mm);

/// Returns the initial t_П [mm]: 0 when feeding starts where the wheel touches this blank. Under
/// position control it is −w and, from a datum, the distance by which the wheel starts deeper (a
/// larger blank) or farther away.
[[nodiscard]] double firstFeed(const Project& project, double totalInfeed_mm);

} // namespace sparkout
