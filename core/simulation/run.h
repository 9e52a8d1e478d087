// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/contact_compliance.h"
#include "core/process/force.h"
#include "core/process/pass_kernel.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/part.h"
#include "core/simulation/limit_watch.h"
#include "core/simulation/result.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/trajectory.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// One group of zones or sections cut at one width: its coefficients and force factors.
struct CutWidth {
    CutWidth(std::size_t lanes) : coefficients(lanes) {}
    LaneCoefficients coefficients;
    double width_mm = 0; ///< b
    double bks = 0, bkr = 0;
    bool asGiven = false; ///< with a threshold: the coefficients are the states themselves
};

/// State and bookkeeping that traverse and plunge cycles share: lanes, time, peaks, trajectory.
/// A copy goes on from where the run stands; the project must outlive both.
/// Lanes are ordered zone by zone (section by section), K lanes each.
class Run {
public:
    Run(const Project& project, std::vector<CompliantPoint> points, Trajectory* trajectory,
        std::stop_token stop);

    /// Coefficients for a width of cut b [mm], for all lanes.
    [[nodiscard]] CutWidth makeCut(double width_mm) const;
    void setWidth(CutWidth& cut, double width_mm) const;

    /// What the trajectory records of a pass beside its numbers.
    struct PassInfo {
        double duration_s = 0;
        double axialFeed_mm_min = 0; ///< > 0: a stroke, whose visits carry the stroke's end as time
        double radialFeed_mm = 0;
    };

    /// Cuts `count` neighbouring zones or sections from `first` on in one pass. `places[i]` says
    /// where the i-th of them is; without places the pass counts for no peak and no trajectory.
    void cut(std::size_t first, std::size_t count, const CutWidth& width, const PassFeed& feed,
             const Place* places, const PassInfo& info);

    [[nodiscard]] double remaining(std::size_t point) const;
    [[nodiscard]] const Blank& blank() const { return m_blank; }
    /// How deep below first touch a diameter stands when the gauge reads the size [mm].
    [[nodiscard]] double sizeDepth_mm() const { return m_sizeDepth_mm; }

    /// Largest √a since the last call [√mm]: whether the cycle still makes progress.
    double takeLargestRoot();
    /// True when the run must end now: too long, not to be solved, or stopped. Sets the status.
    /// Asked before every revolution, so that even the longest dwell can be stopped.
    bool mustEnd();
    /// Time that passes in a stage of the cycle, counted from 0.
    void advance(double seconds, std::size_t stage) {
        m_result.time_s += seconds;
        m_result.timeByStage_s[stage] += seconds;
    }
    void setStatus(RunStatus status) { m_result.status = status; }
    /// After a step of the cycle that began with this t_П [mm] and at this time; of a double stroke
    /// with its overlap B·n/S_ax, else of a revolution of a plunge.
    void stepDone(double fedBefore_mm, double timeBefore_s, std::size_t stage,
                  std::optional<double> overlap = {}) {
        m_watch.stepDone(m_lanes, {.infeed_mm = fed_mm - fedBefore_mm,
                                   .fed_mm = fed_mm,
                                   .duration_s = m_result.time_s - timeBefore_s,
                                   .overlap = overlap.value_or(1),
                                   .stage = stage,
                                   .isSpiral = !overlap});
    }

    /// From now on passes count for nothing but radii and time: there are no forces, peaks, sums
    /// and limits of them.
    void keepRadiiAlone() {
        m_keepsRadiiAlone = true;
        m_watch.stop();
    }
    /// From now on burning is judged as on a blank larger by so much more [mm] per side.
    void leaveMore(double more_mm) { m_watch.leaveMore(more_mm); }

    /// Points from this one on count for sums, peaks, limits and accuracy; those before it, their
    /// zones' middles, are recorded alone.
    void countFrom(std::size_t point) { m_firstCounted = point; }
    [[nodiscard]] std::size_t firstCounted() const { return m_firstCounted; }

    /// Closes the books of a run with so many steps in each stage; the first `reported` points
    /// become the result's sections.
    SimulationResult finish(const std::vector<int>& stepsByStage, std::size_t gaugePoint,
                            std::size_t reported, const std::vector<Zone>& zones);

    /// What a run has reached so far, none of which ever falls: its books show it at the end.
    [[nodiscard]] double time_s() const { return m_result.time_s; }
    [[nodiscard]] long long visits() const { return m_result.visits; }
    [[nodiscard]] bool surelyBurned() const { return m_watch.surelyBurned(); }
    /// Whether the machine prints a form onto the part: its radii then stand otherwise than the
    /// depths have them, which are those of the machine's frame [MODEL-7].
    [[nodiscard]] bool printsForm() const { return m_printed_mm != nullptr; }
    /// Least and most of a point's diameters D_k now, less the nominal one [mm].
    [[nodiscard]] std::pair<double, double> diameterDeviations(std::size_t point) const;
    /// D_k less the nominal diameter [mm] of two opposite radii at these depths, without a form.
    [[nodiscard]] double diameterDeviation(double depth_mm, double opposite_mm) const {
        return radiusAt(depth_mm) + radiusAt(opposite_mm) - m_project.part->diameter_mm;
    }
    [[nodiscard]] std::size_t pointOf(std::size_t lane) const {
        return lane / static_cast<std::size_t>(m_radii);
    }
    [[nodiscard]] int radii() const { return m_radii; } ///< of a point
    /// The deepest radius of a point, and of all points the one that with its opposite is deepest.
    [[nodiscard]] std::size_t deepestLane(std::size_t point) const;
    [[nodiscard]] std::pair<std::size_t, std::size_t> deepestDiameter() const;
    /// Whether each radius is cut by its own balance alone, without a contact in series.
    [[nodiscard]] bool isEachAlone() const { return !m_contact; }
    /// How far a lane stands below first touch, and the share of the revolution it is visited at.
    [[nodiscard]] double depth_mm(std::size_t lane) const { return m_lanes.depth_mm[lane]; }
    [[nodiscard]] double share(std::size_t lane) const { return m_lanes.share[lane]; }
    /// The balance of each lane of a point at a width of cut.
    [[nodiscard]] LaneBalance balance(std::size_t point, double width_mm) const;
    /// Largest P_z·V_k [W] and largest a [mm] of a stage, from 0.
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
    /// How deep the part's surface stands in a lane: c more than in the machine's frame.
    [[nodiscard]] double partDepth(std::size_t lane) const {
        const double depth_mm = m_lanes.depth_mm[lane];
        return m_printed_mm && depth_mm < beyondReach_mm ? depth_mm + (*m_printed_mm)[lane]
                                                         : depth_mm;
    }
    /// Not a number in a gap.
    [[nodiscard]] double finalRadius(std::size_t lane) const {
        return m_lanes.depth_mm[lane] < beyondReach_mm ? radiusAt(partDepth(lane))
                                                       : std::numeric_limits<double>::quiet_NaN();
    }
    /// Calls with each k < K/2 whose diameter is one.
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
    bool m_isShaft; ///< not a bore
    Blank m_blank;
    double m_sizeDepth_mm; ///< |R_first − R_t|, more by half of what the gauge reads too large
    std::shared_ptr<const std::vector<double>> m_printed_mm; ///< c of each lane; null: no form
    std::vector<std::size_t> m_diameters; ///< k of those that no gap interrupts; empty: all
    int m_radii;
    std::vector<CompliantPoint> m_points;
    ForceLaw m_law;
    Lanes m_lanes;
    PassFunction m_cutPass;
    PeakForces m_peakForces;
    std::optional<ContactCompliance> m_contact; ///< in series, where the passes see to it
    LimitWatch m_watch;
    Trajectory* m_trajectory;
    std::stop_token m_stop;
    SimulationResult m_result;
    std::size_t m_firstCounted = 0;
    bool m_keepsRadiiAlone = false;
    std::size_t m_openStage = 0;        ///< whose sums are being gathered
    std::vector<double> m_openDepth_mm; ///< of each lane when that stage began
    std::vector<double> m_lengthBefore; ///< Σℓ of the points before each, and of all
    double m_largestRoot = 0;
    double m_wheelSpeed_m_s;
};

/// Peak force and power of the cycle from those of its stages.
void keepLargestPeaks(SimulationResult& result);

/// Deepest removal that still counts as none [mm].
inline constexpr double noProgress_mm = 1e-9;

} // namespace sparkout
