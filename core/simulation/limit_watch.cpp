// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/limit_watch.h"

#include "core/project/material.h"
#include "core/project/part.h"
#include "core/simulation/stage_control.h"

#include <algorithm>
#include <utility>

namespace sparkout {

LimitWatch::LimitWatch(const Project& project, const Blank& blank)
    : m_radii(blank.depth_mm.size())
    , m_total(depthAtEnd_mm(project, blank.totalInfeed_mm))
    , m_keepsLast(project.part->tolerance.roughness_ra_um.has_value()) {
    if (const auto& rise = project.material->burn_rise_k) {
        m_burn = std::make_shared<const BurnTable>(BurnModel(project), *rise, m_total);
    }
}

void LimitWatch::prepare(Lanes& lanes) {
    if (m_keepsLast) {
        lanes.keepLastCuts();
        m_laneLast.assign(lanes.root.size(), {});
        m_sectionLast.assign(lanes.root.size() / m_radii, std::nullopt);
    }
}

/// After a pass that did not cut every radius: their last cuts part.
void LimitWatch::placeLanes(const Lanes& lanes, std::size_t first, std::size_t count,
                            const Place* places) {
    for (std::size_t section = first; section < first + count; ++section) {
        const std::optional<Place> whole = std::exchange(m_sectionLast[section], std::nullopt);
        const Place now = places[section - first];
        const double* const root = lanes.root.data() + section * m_radii;
        Place* const last = m_laneLast.data() + section * m_radii;
        for (std::size_t k = 0; k < m_radii; ++k) {
            if (root[k] > 0) {
                last[k] = now;
            } else if (whole) {
                last[k] = *whole;
            }
        }
    }
}

void LimitWatch::judge(const Lanes& lanes, const PassRange& range, double root,
                       const PassFeed& feed, const Place* places) {
    const double fed = feed.greatest();
    if (fed > m_quietEnd) {
        constexpr double quietReach = 0.05; ///< of the whole infeed
        m_quietEnd = fed + quietReach * m_total;
        m_quietLimit = m_burn->limit(m_total - m_quietEnd);
        m_quietRoot = m_usage * m_quietLimit;
        if (root <= m_quietRoot) {
            return;
        }
    }
    if (fed > m_stretchEnd) {
        openStretch(lanes, fed);
    }
    const double most = worst(lanes, range);
    if (most > m_usage) {
        m_usage = most;
        m_quietRoot = most * m_quietLimit;
        keep(lanes, range, places);
    }
}

/// From the most that is left anywhere to below what this pass may leave, as far as one polynomial
/// reaches. Radii only grow deeper, so none leaves it at its upper end. The less is left the more
/// the curve bends: what was too far once is not tried again.
void LimitWatch::openStretch(const Lanes& lanes, double fed_mm) {
    constexpr double leastSpread = 1e-3; ///< of the whole infeed
    const double least = *std::min_element(lanes.depth_mm.begin(), lanes.depth_mm.end());
    const double left = std::max(0.0, m_total - fed_mm);
    const double high = std::max(m_total - least, left + leastSpread * m_total);
    const double spread = high - left;
    for (;; m_reach /= 2) {
        const double further = m_reach < leastReach ? 0 : m_reach * spread;
        const double low = std::max(0.0, left - further);
        m_stretch = m_burn->over(low, high, m_total);
        if (m_stretch) {
            m_stretchEnd = low > 0 ? m_total - low : std::numeric_limits<double>::max();
            return;
        }
        if (further == 0) {
            break;
        }
    }
    constexpr double tryAgain = 0.1;
    m_stretchEnd = fed_mm + tryAgain * spread;
}

double LimitWatch::usage(const Lanes& lanes, std::size_t lane) const {
    return m_stretch ? m_stretch->usage(lanes.root[lane], lanes.depth_mm[lane])
                     : m_burn->usage(lanes.root[lane], m_total - lanes.depth_mm[lane]);
}

double LimitWatch::worst(const Lanes& lanes, const PassRange& range) const {
    if (m_stretch) {
        return m_stretch->worst(lanes.root.data() + range.first,
                                lanes.depth_mm.data() + range.first, range.count);
    }
    double most = 0;
    const double* const root = lanes.root.data() + range.first;
    const double* const depth_mm = lanes.depth_mm.data() + range.first;
    for (std::size_t i = 0; i < range.count; ++i) {
        if (root[i] > m_quietRoot) { // else no new worst
            most = std::max(most, m_burn->usage(root[i], m_total - depth_mm[i]));
        }
    }
    return most;
}

/// The visit of this pass that is the worst so far.
void LimitWatch::keep(const Lanes& lanes, const PassRange& range, const Place* places) {
    const std::size_t end = range.first + range.count;
    if (m_lane < range.first || m_lane >= end || usage(lanes, m_lane) != m_usage) {
        m_lane = range.first; // mostly it is the lane that it was before
        while (m_lane + 1 < end && usage(lanes, m_lane) != m_usage) {
            ++m_lane;
        }
    }
    std::size_t zone = 0, radius = m_lane - range.first;
    for (; radius >= m_radii; radius -= m_radii) { // few zones: a division takes longer
        ++zone;
    }
    m_worst = {.depth_mm = lanes.root[m_lane] * lanes.root[m_lane],
               .stock_mm = std::max(0.0, m_total - lanes.depth_mm[m_lane]),
               .radius = static_cast<int>(radius),
               .at = places[zone]};
}

void LimitWatch::put(SimulationResult& result, const Lanes& lanes) const {
    if (m_burn && m_usage > 0) {
        result.burn = m_worst;
    }
    std::vector<SectionResult>& sections =
        result.zoneSections.empty() ? result.sections : result.zoneSections;
    const std::size_t first = result.zoneSections.empty() ? 0 : result.sections.size();
    for (std::size_t i = 0; m_keepsLast && i < sections.size(); ++i) {
        const std::size_t section = first + i;
        std::size_t lane = section * m_radii;
        for (std::size_t other = lane + 1; other < (section + 1) * m_radii; ++other) {
            lane = lanes.lastCut(other) > lanes.lastCut(lane) ? other : lane;
        }
        if (const double most = lanes.lastCut(lane); most > 0) {
            sections[i].lastCut = LastCut{.depth_mm = most * most,
                                          .radius = static_cast<int>(lane % m_radii),
                                          .at = m_sectionLast[section].value_or(m_laneLast[lane])};
        }
    }
}

} // namespace sparkout
