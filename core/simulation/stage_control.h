// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/project.h"
#include "core/simulation/gauge_signal.h"

#include <cstddef>
#include <span>
#include <vector>

namespace sparkout {

/// Infeed per step of each stage of the project's cycle [mm]; 0 where none is set.
[[nodiscard]] std::vector<double> infeedsOfStages(const Project& project);
/// What a step of each stage feeds at most [mm]: its infeed, and the continuous infeed S_c during
/// the longest of its double strokes.
[[nodiscard]] std::vector<double> fedByStep_mm(const Project& project);

/// Decides what is fed next and when a stage of the cycle ends [MODEL-7]. One step is a double
/// stroke (traverse) or a revolution (plunge).
class StageControl {
public:
    /// `feeds_mm` is each stage's infeed per step; `totalInfeed_mm` = |R_first − R_t|.
    StageControl(const Project& project, std::vector<double> feeds_mm, double totalInfeed_mm);

    [[nodiscard]] bool finished() const { return m_stage == m_feeds.size(); }
    /// The running stage, counted from 0.
    [[nodiscard]] std::size_t stage() const { return m_stage; }
    /// Infeed of the next step [mm] when `fed_mm` has been fed: none in a spark-out stage, cut
    /// short at the stage's end under position control.
    [[nodiscard]] double nextInfeed(double fed_mm) const;
    /// The t_П that a continuous infeed does not pass [mm]: under position control the stage's end.
    [[nodiscard]] double mostFed() const;
    /// Whether the running stage waits for size without feeding, so that it may wait for ever.
    [[nodiscard]] bool waitsForSize() const;
    /// Whether the running stage draws the wheel head back (negative feed): what it removes comes
    /// from the stored deflection. It ends as any other, or when nothing is cut any more; an option
    /// beyond the sources [MODEL-7].
    [[nodiscard]] bool retracts() const;
    /// Ends the running stage: it is over, or a retraction that has lost contact.
    void endStage() { ++m_stage; }
    /// One step is done, which ends at this time; ends the stages that are through. Several may end
    /// at one reading.
    void stepDone(double remainingStock_mm, double fed_mm, double time_s);
    /// The step without the ends of stages.
    void read(double remainingStock_mm, double time_s);
    /// How much larger the stock may be [mm] for the running stage to end at this step still: it
    /// ends where this is not below 0. Infinite where the stock does not decide.
    [[nodiscard]] double overBy(double fed_mm) const;
    /// The same for it to wait but until the control learns that it is over.
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

/// What the gauge reads of one section: remaining stock per side Π_rem [mm] from the depths of its
/// radii, D_k = R_k + R_{k+K/2}, by the gauge's rule, and the depth at which it reads the size;
/// mirrored in a bore.
[[nodiscard]] double remainingStock(const double* depth_mm, int radii, GaugeRule rule,
                                    double sizeDepth_mm);

/// The same of the diameters with these k alone, which no gap interrupts; at least one.
[[nodiscard]] double remainingStock(const double* depth_mm, int radii,
                                    std::span<const std::size_t> diameters, GaugeRule rule,
                                    double sizeDepth_mm);

/// w under position control [mm]: the head stands where it would with a new wheel, and the worn
/// one's surface that much farther from the part [MODEL-7]. Under gauge control 0, for there
/// feeding starts at the touch and ends by the reading.
[[nodiscard]] double standsBack_mm(const Project& project);

/// How deep below first touch a cycle that ends by itself leaves a radius [mm]: |R_first − R_t|,
/// under gauge control more by half of what the gauge reads too large.
[[nodiscard]] double depthAtEnd_mm(const Project& project, double totalInfeed_mm);

/// t_П at which position control takes the part to be at size [mm]: |R_first − R_t| − w.
[[nodiscard]] double fedAtSize(const Project& project, double totalInfeed_mm);

/// t_П at the beginning [mm]: 0 when feeding starts where the wheel touches this blank. Under
/// position control −w, and from a datum how much deeper (a larger blank) or farther away.
[[nodiscard]] double firstFeed(const Project& project, double totalInfeed_mm);

} // namespace sparkout
