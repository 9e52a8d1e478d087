// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/contact_compliance.h"
#include "core/process/force.h"
#include "core/process/pass_kernel.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/process/wheel_wave.h"
#include "core/project/part.h"
#include "core/simulation/limit_watch.h"
#include "core/simulation/result.h"
#include "core/simulation/stage_control.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// A group of zones or sections cut at one width: its coefficients and force factors.
struct CutWidth {
    CutWidth(std::size_t lanes) : coefficients(lanes) {}
    LaneCoefficients coefficients;
    double width_mm = 0; ///< b
    double bks = 0, bkr = 0;
    bool asGiven = false; ///< with a threshold: the coefficients are the states themselves
};

/// State and sums that traverse and plunge cycles share: lanes, time, peaks, trajectory. A copy
/// continues from the state of the run; the project must outlive both. Lanes are ordered zone by
/// zone (section by section), K lanes each.
class Run {
public:
    Run(const Project& project, std::vector<CompliantPoint> points, Trajectory* trajectory,
        std::stop_token stop);

    /// Returns the coefficients for a width of cut b [mm], for all lanes.
    [[nodiscard]] CutWidth makeCut(double width_mm) const;
    void setWidth(CutWidth& cut, double width_mm) const;

    /// Values of a pass that only the trajectory records.
    struct PassInfo {
        double duration_s = 0;
        double axialFeed_mm_min = 0; ///< > 0: a stroke, whose visits carry the stroke's end as time
        double radialFeed_mm = 0;
    };

    /// Returns the feed of a pass that is due this much later, with the wave of a wheel out of
    /// true. The pass must be cut before the next one is asked for.
    [[nodiscard]] PassFeed withWave(PassFeed feed, double later_s = 0);
    /// Returns whether the wheel prints waves, so that passes differ by the time at which they
    /// begin.
    [[nodiscard]] bool printsWaves() const { return m_wave.has_value(); }
    /// Where the surface of the wheel stands at radius k in such a pass [mm].
    [[nodiscard]] double wheelAt(std::size_t k, const PassFeed& feed) const {
        return m_lanes.wheelAt(k, feed);
    }

    /// Cuts `count` neighbouring zones or sections from `first` on in one pass. `places[i]` is the
    /// place of the i-th of them; without places the pass does not count for peaks and trajectory.
    void cut(std::size_t first, std::size_t count, const CutWidth& width, const PassFeed& feed,
             const Place* places, const PassInfo& info);

    [[nodiscard]] double remaining(std::size_t point) const;
    [[nodiscard]] const Blank& blank() const { return m_blank; }
    /// Returns the depth below first touch of a diameter when the gauge reads the size [mm].
    [[nodiscard]] double sizeDepth_mm() const { return m_sizeDepth_mm; }

    /// Returns the largest √a since the last call [√mm], which shows whether the cycle makes
    /// progress.
    double takeLargestRoot();
    /// Returns whether the run must end now, because it is too long, cannot be solved or was
    /// stopped, and sets the status. It is called before every revolution, so that even the longest
    /// dwell can be stopped.
    bool mustEnd();
    /// Advances the time in a stage of the cycle, counted from 0.
    void advance(double seconds, std::size_t stage) {
        m_result.time_s += seconds;
        m_result.timeByStage_s[stage] += seconds;
    }
    void setStatus(RunStatus status) { m_result.status = status; }
    /// Records the end of a step that began with this t_П [mm] and at this time: a double stroke
    /// with its overlap B·n/S_ax, or without overlap a revolution of a plunge cycle.
    void stepDone(double fedBefore_mm, double timeBefore_s, std::size_t stage,
                  std::optional<double> overlap = {}) {
        m_watch.stepDone(m_lanes, {.infeed_mm = fed_mm - fedBefore_mm,
                                   .fed_mm = fed_mm,
                                   .duration_s = m_result.time_s - timeBefore_s,
                                   .overlap = overlap.value_or(1),
                                   .stage = stage,
                                   .isSpiral = !overlap});
    }

    /// Computes only radii and time from now on, without forces, peaks, sums and limits.
    void keepRadiiAlone() {
        m_keepsRadiiAlone = true;
        m_watch.stop();
    }
    /// Judges burning from now on as on a blank larger by this much [mm] per side.
    void leaveMore(double more_mm) { m_watch.leaveMore(more_mm); }

    /// Counts points from this one on for sums, peaks, limits and accuracy; those before it, the
    /// middles of their zones, are only recorded.
    void countFrom(std::size_t point) { m_firstCounted = point; }
    [[nodiscard]] std::size_t firstCounted() const { return m_firstCounted; }

    /// Returns the result of a run with this number of steps in each stage; the first `reported`
    /// points become its sections.
    SimulationResult finish(const std::vector<int>& stepsByStage, std::size_t gaugePoint,
                            std::size_t reported, const std::vector<Zone>& zones);

    /// Values of the run so far, which never fall; the result has the final ones.
    [[nodiscard]] double time_s() const { return m_result.time_s; }
    [[nodiscard]] long long visits() const { return m_result.visits; }
    [[nodiscard]] bool surelyBurned() const { return m_watch.surelyBurned(); }
    /// Returns the least and greatest of a point's current diameters D_k, less the nominal one
    /// [mm].
    [[nodiscard]] std::pair<double, double> diameterDeviations(std::size_t point) const;
    /// Returns D_k less the nominal diameter [mm] for two opposite radii at these depths, without a
    /// printed form.
    [[nodiscard]] double diameterDeviation(double depth_mm, double opposite_mm) const {
        return radiusAt(depth_mm) + radiusAt(opposite_mm) - m_project.part->diameter_mm;
    }
    [[nodiscard]] std::size_t pointOf(std::size_t lane) const {
        return lane / static_cast<std::size_t>(m_radii);
    }
    [[nodiscard]] int radii() const { return m_radii; } ///< number of radii of a point
    /// Lane of the deepest radius of a point, and lanes of the deepest diameter of all points.
    [[nodiscard]] std::size_t deepestLane(std::size_t point) const;
    [[nodiscard]] std::pair<std::size_t, std::size_t> deepestDiameter() const;
    /// Returns whether a radius can be followed by itself: it has its own balance, without a
    /// contact in series, its depth is that of the part, and each pass is as any other.
    [[nodiscard]] bool isEachAlone() const { return !m_contact && !m_printed_mm && !printsWaves(); }
    /// Depth of a lane below first touch, and the share of the revolution at which it is visited.
    [[nodiscard]] double depth_mm(std::size_t lane) const { return m_lanes.depth_mm[lane]; }
    [[nodiscard]] double share(std::size_t lane) const { return m_lanes.share[lane]; }
    /// Returns the balance of each lane of a point at a width of cut.
    [[nodiscard]] LaneBalance balance(std::size_t point, double width_mm) const;
    /// Returns the sums and peaks of a stage, counted from 0.
    [[nodiscard]] const StageSums& sumsOf(std::size_t stage) const {
        return m_result.sumsByStage[stage];
    }

    double fed_mm = 0; ///< t_П

private:
    void openStage(std::size_t stage);
    void closeStage();
    [[nodiscard]] double cutLanes(const CutWidth& width, const PassFeed& feed,
                                  const PassRange& range);
    void tally(double root, std::size_t first, std::size_t count, const CutWidth& width,
               const Place* places);
    void keepPeaks(StageSums& sums, double root, std::size_t first, std::size_t count,
                   const CutWidth& width, const Place* places);
    void record(std::size_t point, const CutWidth& width, const PassFeed& feed, const Place& place,
                const PassInfo& info);
    /// Returns the depth of the part's surface in a lane: c more than in the machine's frame.
    [[nodiscard]] double partDepth(std::size_t lane) const {
        const double depth_mm = m_lanes.depth_mm[lane];
        return m_printed_mm && depth_mm < beyondReach_mm ? depth_mm + (*m_printed_mm)[lane]
                                                         : depth_mm;
    }
    /// Returns the radius of a lane, not a number in a gap.
    [[nodiscard]] double finalRadius(std::size_t lane) const {
        return m_lanes.depth_mm[lane] < beyondReach_mm ? radiusAt(partDepth(lane))
                                                       : std::numeric_limits<double>::quiet_NaN();
    }
    /// Calls `with` for each k < K/2 whose diameter no gap interrupts.
    template <class Do>
    void forDiameters(const Do& with) const {
        for (const std::size_t k : m_diameters) {
            with(k);
        }
        const auto half = static_cast<std::size_t>(m_radii) / 2;
        for (std::size_t k = 0; m_diameters.empty() && k < half; ++k) {
            with(k);
        }
    }
    [[nodiscard]] double radiusAt(double depth_mm) const {
        return m_isShaft ? m_blank.firstTouchRadius_mm - depth_mm
                         : m_blank.firstTouchRadius_mm + depth_mm;
    }
    [[nodiscard]] SectionResult sectionResult(std::size_t point, Zone zone) const;
    void foldZoneSections();

    const Project& m_project;
    bool m_isShaft; ///< external grinding
    Blank m_blank;
    double m_sizeDepth_mm; ///< |R_first − R_t| plus half of the gauge's excess reading
    std::shared_ptr<const std::vector<double>> m_printed_mm; ///< c of each lane; null: no form
    std::optional<WheelWave> m_wave;      ///< empty: the runout of the wheel is not known
    std::vector<std::size_t> m_diameters; ///< k of the diameters without a gap; empty: all
    int m_radii;
    std::vector<CompliantPoint> m_points;
    ForceLaw m_law;
    Lanes m_lanes;
    PassFunction m_cutPass;
    PeakForces m_peakForces;
    std::optional<ContactCompliance> m_contact; ///< contact in series, where the passes include it
    LimitWatch m_watch;
    Trajectory* m_trajectory;
    std::stop_token m_stop;
    SimulationResult m_result;
    std::size_t m_firstCounted = 0;
    bool m_keepsRadiiAlone = false;
    std::size_t m_openStage = 0;        ///< stage whose sums are being computed
    std::vector<double> m_openDepth_mm; ///< depth of each lane when that stage began
    std::vector<double> m_lengthBefore; ///< Σℓ of the points before each, and of all
    double m_largestRoot = 0;
    double m_wheelSpeed_m_s;
};

/// Sets the peak force and power of the cycle from those of its stages.
void keepLargestPeaks(SimulationResult& result);

/// Deepest removal that still counts as none [mm].
inline constexpr double noProgress_mm = 1e-9;

} // namespace sparkout
