// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"
#include "core/process/profile.h"
#include "core/simulation/result.h"
#include "core/surface/burn_table.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// Values of a run's passes for the requirements of the project that the peaks of the stages do not
/// cover [MODEL-8]: the visit nearest to burning, and for the roughness the depth that the last
/// step with infeed took off each radius. Requirements that are not set cost nothing; no pass
/// allocates.
///
/// Burn is judged by √a over the greatest √a whose damaged layer stays within the remaining stock.
/// Most passes need only a quick check: no lane is nearer than their largest √a would be at a stock
/// slightly less than all of theirs. Passes that may be the worst so far are searched with the
/// polynomial of a stretch of stocks, or if none fits with the table, accurate to two millionths of
/// √a.
class LimitWatch {
public:
    LimitWatch(const Project& project, const Blank& blank);

    void prepare(const Lanes& lanes);
    /// Records a pass of `count` zones or sections from `first` on whose largest √a is `root`;
    /// `places[i]` is the place of the i-th of them.
    void passDone(const Lanes& lanes, const PassRange& range, double root, const PassFeed& feed,
                  const Place* places, std::size_t first, std::size_t count) {
        if (m_keepsLast) {
            placeStep(first, count, places);
        }
        if (m_burn && (root > m_quietRoot || feed.greatest() > m_quietEnd)) {
            judge(lanes, range, root, feed, places);
        }
    }
    /// A step of the cycle.
    struct Step {
        double infeed_mm = 0; ///< 0 or less in a spark-out
        double fed_mm = 0;
        double duration_s = 0;
        double overlap = 1; ///< B·n/S_ax of a double stroke
        std::size_t stage = 0;
        bool isSpiral = false; ///< a revolution with an infeed that grows with the angle
    };
    /// Takes the end of a revolution or double stroke.
    void stepDone(const Lanes& lanes, const Step& step) {
        if (m_keepsLast) {
            keepStep(lanes, step);
        }
    }
    /// Stops watching and discards the values so far.
    void stop() {
        m_burn.reset();
        m_keepsLast = false;
        m_last = {};
    }
    /// Discards the worst visit and restarts with these lanes.
    void restart(const Lanes& lanes) {
        m_usage = m_quietRoot = 0;
        m_reach = farReach;
        m_worst = {};
        m_quietEnd = m_stretchEnd = std::numeric_limits<double>::lowest();
        prepare(lanes);
    }
    /// Adds this much stock [mm] below every later cut, as in a larger blank.
    void leaveMore(double more_mm) {
        m_total += more_mm;
        m_quietEnd = m_stretchEnd = std::numeric_limits<double>::lowest();
    }
    /// Returns whether a visit burned by more than the error of the table of limits.
    [[nodiscard]] bool surelyBurned() const {
        constexpr double generously = 1e-4; // relative to √a
        return m_usage > 1 + generously && m_burn->isResolved();
    }
    /// Writes the kept values to a result with its sections and counts: the watched lanes are those
    /// of its sections or, where zones have several, those of their sections after them.
    void put(SimulationResult& result) const;

private:
    void judge(const Lanes& lanes, const PassRange& range, double root, const PassFeed& feed,
               const Place* places);
    void placeStep(std::size_t first, std::size_t count, const Place* places);
    void keepStep(const Lanes& lanes, const Step& step);
    void openStretch(const Lanes& lanes, double fed_mm);
    [[nodiscard]] double usage(const Lanes& lanes, std::size_t lane) const;
    [[nodiscard]] double worst(const Lanes& lanes, const PassRange& range) const;
    void keep(const Lanes& lanes, const PassRange& range, const Place* places);

    std::size_t m_radii;
    double m_total; ///< depth at which the cycle ends: depthAtEnd_mm() [mm]
    bool m_keepsLast;
    /// The last step with infeed.
    struct LastStep {
        std::vector<double> before_mm; ///< depth of each lane when the running step began
        std::vector<double> taken_mm;  ///< depth taken off each lane; 0: not cut yet
        std::vector<double> pressed_mm;
        std::vector<Place> at;      ///< place of its first pass over each section
        std::vector<Place> begun;   ///< for the running step, if it has one
        std::vector<char> hasBegun; ///< by section
        std::size_t stage = 0;      ///< stage of the last complete step
        double infeed_mm = 0;       ///< infeed of that step; 0: there is none
        double duration_s = 0;
        double overlap = 1;
        double sparkOut_s = 0; ///< time of the later steps
    };
    LastStep m_last;
    std::shared_ptr<const BurnTable> m_burn; ///< shared by the copies of a run
    std::optional<BurnStretch> m_stretch;    ///< stretch of the stocks at the current passes
    static constexpr double farReach = 3, leastReach = 0.3;
    double m_reach =
        farReach; ///< extent of a stretch beyond the remaining stocks, in terms of their spread
    double m_stretchEnd = std::numeric_limits<double>::lowest(); ///< its greatest t_П [mm]
    /// Up to this t_П no limit of √a is below m_quietLimit, and no pass with a √a up to m_quietRoot
    /// is a new worst one.
    double m_quietEnd = std::numeric_limits<double>::lowest();
    double m_quietLimit = 0, m_quietRoot = 0;
    double m_usage = 0;     ///< √a over its limit, of the worst visit
    std::size_t m_lane = 0; ///< lane of that visit
    BurnVisit m_worst;
};

} // namespace sparkout
