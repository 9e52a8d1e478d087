// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/burn_table.h"
#include "core/process/pass_kernel.h"
#include "core/process/profile.h"
#include "core/simulation/result.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// What a run keeps of its passes for the requirements that the project states and that the peaks
/// of the stages do not answer [MODEL-8]: the visit nearest to burning, and for the roughness what
/// the last step with infeed took off each radius. What is not asked for costs nothing; no pass
/// allocates.
///
/// Burn is judged by √a over the greatest one whose damaged layer stays within the stock left. Most
/// passes are done with at a glance: no lane is nearer than their largest √a would be at a stock a
/// little less than any they leave. Those that may be the worst so far are looked through by the
/// polynomial of a stretch of stocks, or where none fits by the table, true to two millionths of
/// √a.
class LimitWatch {
public:
    LimitWatch(const Project& project, const Blank& blank);

    void prepare(const Lanes& lanes);
    /// After a pass of `count` zones or sections from `first` on whose largest √a is `root`;
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
    /// A step of the cycle: what it fed, and t_П at its end.
    struct Step {
        double infeed_mm = 0; ///< none or less in a spark-out
        double fed_mm = 0;
        double duration_s = 0;
        double overlap = 1; ///< B·n/S_ax of a double stroke
        std::size_t stage = 0;
        bool isSpiral = false; ///< of a revolution in which the infeed grows with the angle
    };
    /// After the passes of a revolution or double stroke.
    void stepDone(const Lanes& lanes, const Step& step) {
        if (m_keepsLast) {
            keepStep(lanes, step);
        }
    }
    /// Watches no further pass, and forgets those before.
    void stop() {
        m_burn.reset();
        m_keepsLast = false;
        m_last = {};
    }
    /// Forgets the worst so far, for lanes from the start.
    void restart(const Lanes& lanes) {
        m_usage = m_quietRoot = 0;
        m_reach = farReach;
        m_worst = {};
        m_quietEnd = m_stretchEnd = std::numeric_limits<double>::lowest();
        prepare(lanes);
    }
    /// From now on so much more [mm] is left below every cut, as of a larger blank.
    void leaveMore(double more_mm) {
        m_total += more_mm;
        m_quietEnd = m_stretchEnd = std::numeric_limits<double>::lowest();
    }
    /// Whether a visit burned beyond doubt: the table of limits is off by less.
    [[nodiscard]] bool surelyBurned() const {
        constexpr double generously = 1e-4; // of √a
        return m_usage > 1 + generously && m_burn->isResolved();
    }
    /// Puts what was kept into the result, whose sections and counts are there: the lanes watched
    /// are those of its sections, and where zones hold several those of these after them.
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
        std::vector<double> before_mm; ///< how deep each lane stood when the running step began
        std::vector<double> taken_mm;  ///< off each lane; 0: not cut yet
        std::vector<double> pressed_mm;
        std::vector<Place> at;      ///< its first pass over each section
        std::vector<Place> begun;   ///< that of the running step, of those that have one
        std::vector<char> hasBegun; ///< by section
        std::size_t stage = 0;      ///< of the last whole one
        double infeed_mm = 0;       ///< of that one; 0: there is none
        double duration_s = 0;
        double overlap = 1;
        double sparkOut_s = 0; ///< since it
    };
    LastStep m_last;
    std::shared_ptr<const BurnTable> m_burn; ///< the same in copies of a run
    std::optional<BurnStretch> m_stretch;    ///< of the stocks the passes are at
    static constexpr double farReach = 3, leastReach = 0.3;
    double m_reach = farReach; ///< of a stretch beyond the stocks that are left, of their spread
    double m_stretchEnd = std::numeric_limits<double>::lowest(); ///< its greatest t_П [mm]
    /// Up to this t_П no limit of √a is below m_quietLimit, no pass up to m_quietRoot a new worst.
    double m_quietEnd = std::numeric_limits<double>::lowest();
    double m_quietLimit = 0, m_quietRoot = 0;
    double m_usage = 0;     ///< √a over its limit, of the worst visit
    std::size_t m_lane = 0; ///< of that visit
    BurnVisit m_worst;
};

} // namespace sparkout
