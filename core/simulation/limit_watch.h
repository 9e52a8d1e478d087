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
/// of the stages do not answer [MODEL-8]: the visit nearest to burning, and the last cut of each
/// radius for the roughness. What is not asked for costs nothing; no pass allocates.
///
/// Burn is judged by √a over the greatest one whose damaged layer stays within the stock left. Most
/// passes are done with at a glance: no lane is nearer than their largest √a would be at a stock a
/// little less than any they leave. Those that may be the worst so far are looked through by the
/// polynomial of a stretch of stocks, or where none fits by the table, true to two millionths of
/// √a.
class LimitWatch {
public:
    LimitWatch(const Project& project, const Blank& blank);

    void prepare(Lanes& lanes);
    /// After a pass of `count` zones or sections from `first` on whose largest √a is `root`;
    /// `places[i]` is the place of the i-th of them.
    void passDone(const Lanes& lanes, const PassRange& range, double root, const PassFeed& feed,
                  const Place* places, std::size_t first, std::size_t count) {
        if (m_keepsLast && lanes.leastRoot > 0) {
            std::copy_n(places, count, m_sectionLast.begin() + static_cast<std::ptrdiff_t>(first));
        } else if (m_keepsLast) {
            placeLanes(lanes, first, count, places);
        }
        if (m_burn && (root > m_quietRoot || feed.greatest() > m_quietEnd)) {
            judge(lanes, range, root, feed, places);
        }
    }
    /// Watches no further pass, and forgets those before.
    void stop() {
        m_burn.reset();
        m_keepsLast = false;
        m_laneLast = {};
        m_sectionLast = {};
    }
    /// Forgets the worst so far, for lanes from the start; their last cuts are the lanes'.
    void restart() {
        m_usage = m_quietRoot = 0;
        m_reach = farReach;
        m_worst = {};
        m_quietEnd = m_stretchEnd = std::numeric_limits<double>::lowest();
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
    /// Puts what was kept into the result, whose sections and counts are there: the lanes are those
    /// of its sections, and where zones hold several those of these after them.
    void put(SimulationResult& result, const Lanes& lanes) const;

private:
    void judge(const Lanes& lanes, const PassRange& range, double root, const PassFeed& feed,
               const Place* places);
    void placeLanes(const Lanes& lanes, std::size_t first, std::size_t count, const Place* places);
    void openStretch(const Lanes& lanes, double fed_mm);
    [[nodiscard]] double usage(const Lanes& lanes, std::size_t lane) const;
    [[nodiscard]] double worst(const Lanes& lanes, const PassRange& range) const;
    void keep(const Lanes& lanes, const PassRange& range, const Place* places);

    std::size_t m_radii;
    double m_total; ///< depth at which the cycle ends: depthAtEnd_mm() [mm]
    bool m_keepsLast;
    std::vector<std::optional<Place>> m_sectionLast; ///< where all radii were cut last, if at once
    std::vector<Place> m_laneLast;                   ///< else where each of them was
    std::shared_ptr<const BurnTable> m_burn;         ///< the same in copies of a run
    std::optional<BurnStretch> m_stretch;            ///< of the stocks the passes are at
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
