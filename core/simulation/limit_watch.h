// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/pass_kernel.h"
#include "core/process/profile.h"
#include "core/quality/burn_table.h"
#include "core/simulation/result.h"

#include <cstdint>
#include <memory>

namespace sparkout {

/// What a run keeps of its passes for the requirements that the project states and that the peaks
/// of the stages do not answer [MODEL-8]: the visit nearest to burning, and the last cut of each
/// radius for the roughness. What is not asked for costs nothing; no pass allocates.
///
/// Burn is judged by the depth of cut over the greatest one whose damaged layer stays within the
/// stock left (BurnTable). The lanes are looked through only after a pass whose bound exceeds the
/// worst so far; worst and bound are the table's, true to a millionth of √a.
class LimitWatch {
public:
    LimitWatch(const Project& project, const Blank& blank);

    void prepare(Lanes& lanes) const;
    /// The number of a pass of `count` zones or sections, for PassRange.
    [[nodiscard]] std::uint64_t number(const Place* places, std::size_t count) const {
        return m_keepsLast ? pack(places, count) : 0;
    }
    /// After a pass whose largest √a is `root`; `places[i]` is the place of the i-th zone.
    void passDone(const Lanes& lanes, const PassRange& range, double root, const PassFeed& feed,
                  const Place* places) {
        if (m_burn && m_burn->bound(root, std::max(feed.at(0), feed.at(1)), m_total) > m_usage) {
            lookThrough(lanes, range, places);
        }
    }
    /// Forgets the worst so far; the lanes' last cuts are the lanes'.
    void restart() {
        m_usage = 0;
        m_worst = {};
    }
    /// √a over its limit, of the visit nearest to burning so far; 0 where burn is not asked for.
    [[nodiscard]] double burnUsage() const { return m_usage; }
    /// Puts what was kept into the result, whose sections and counts are there.
    void put(SimulationResult& result, const Lanes& lanes) const;

private:
    [[nodiscard]] static std::uint64_t pack(const Place* places, std::size_t count);
    [[nodiscard]] static Place unpack(std::uint64_t number, const SimulationResult& result,
                                      std::size_t section);
    void lookThrough(const Lanes& lanes, const PassRange& range, const Place* places);

    std::size_t m_radii;
    double m_total; ///< |R_first − R_t| [mm]
    bool m_keepsLast;
    std::shared_ptr<const BurnTable> m_burn; ///< the same in copies of a run
    double m_usage = 0;                      ///< √a over its limit, of the worst visit
    std::size_t m_lane = 0;                  ///< of that visit
    BurnVisit m_worst;
};

} // namespace sparkout
