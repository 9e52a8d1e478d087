// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/limit_watch.h"

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

// A pass number: double stroke or revolution, revolution within the step, whether the pass goes
// over several zones, and the steps of up to three of them. No run has 2^24 passes (maxVisits).
constexpr int cycleShift = 40, revolutionShift = 16, severalShift = 9, stepBits = 3;
constexpr std::uint64_t revolutionMask = (1U << 24) - 1, stepMask = (1U << stepBits) - 1;
constexpr std::size_t zones = 3;

/// The stage that a double stroke or revolution belongs to, from 1. One that was not finished
/// belongs to the stage that ran last.
int stageOf(int cycleCount, const SimulationResult& result) {
    int done = 0, last = 1;
    for (std::size_t z = 0; z < result.countsByStage.size(); ++z) {
        done += result.countsByStage[z];
        if (done >= cycleCount) {
            return static_cast<int>(z) + 1;
        }
        last = result.timeByStage_s[z] > 0 ? static_cast<int>(z) + 1 : last;
    }
    return last;
}

} // namespace

LimitWatch::LimitWatch(const Project& project, const Blank& blank)
    : m_radii(blank.depth_mm.size())
    , m_total(blank.totalInfeed_mm)
    , m_keepsLast(project.part.tolerance.roughness_ra_um.has_value()) {
    if (const auto& rise = project.material.burn_rise_k) {
        m_burn = std::make_shared<const BurnTable>(BurnModel(project), *rise, m_total);
    }
}

void LimitWatch::prepare(Lanes& lanes) const {
    if (m_keepsLast) {
        lanes.keepLastCuts();
    }
}

std::uint64_t LimitWatch::pack(const Place* places, std::size_t count) {
    if (!places) {
        return 0;
    }
    std::uint64_t number = static_cast<std::uint64_t>(places->cycleCount) << cycleShift
                           | static_cast<std::uint64_t>(places->revolution) << revolutionShift
                           | static_cast<std::uint64_t>(count > 1) << severalShift;
    for (std::size_t i = 0; i < std::min(count, zones); ++i) {
        number |= static_cast<std::uint64_t>(places[i].step) << (i * stepBits);
    }
    return number;
}

Place LimitWatch::unpack(std::uint64_t number, const SimulationResult& result,
                         std::size_t section) {
    Place place;
    place.zone = result.sections[section].zone;
    place.section = static_cast<int>(section);
    place.cycleCount = static_cast<int>(number >> cycleShift);
    place.revolution = static_cast<int>(number >> revolutionShift & revolutionMask);
    place.stage = stageOf(place.cycleCount, result);
    if (place.zone != Zone::section) {
        const bool several = number >> severalShift & 1;
        place.step = static_cast<Step>(number >> (several ? section * stepBits : 0) & stepMask);
    }
    return place;
}

void LimitWatch::judge(const Lanes& lanes, const PassRange& range, double root,
                       const PassFeed& feed, const Place* places) {
    const double fed = std::max(feed.at(0), feed.at(1));
    if (m_burn->bound(root, fed, m_total) > m_usage) {
        if (fed > m_stretchEnd) {
            openStretch(lanes, fed);
        }
        const double most = worst(lanes, range);
        if (most > m_usage) {
            m_usage = most;
            keep(lanes, range, places);
        }
    }
    constexpr double quietReach = 0.02; ///< of the whole infeed
    m_quietEnd = mostFed(feed) + quietReach * m_total;
    m_quietRoot = m_usage * m_burn->limit(m_total - m_quietEnd);
}

/// From the most that is left anywhere to below what this pass may leave, as far as one polynomial
/// reaches. Radii only grow deeper, so none leaves it at its upper end.
void LimitWatch::openStretch(const Lanes& lanes, double fed_mm) {
    constexpr double leastSpread = 1e-3; ///< of the whole infeed
    const double least = *std::min_element(lanes.depth_mm.begin(), lanes.depth_mm.end());
    const double left = std::max(0.0, m_total - fed_mm);
    const double high = std::max(m_total - least, left + leastSpread * m_total);
    const double spread = high - left;
    for (const double further : {3.0, 1.0, 0.0}) {
        const double low = std::max(0.0, left - further * spread);
        m_stretch = m_burn->over(low, high, m_total);
        if (m_stretch) {
            m_stretchEnd = low > 0 ? m_total - low : std::numeric_limits<double>::max();
            return;
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
    for (std::size_t lane = range.first; lane < range.first + range.count; ++lane) {
        most = std::max(most, usage(lanes, lane));
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
    for (std::size_t section = 0; m_keepsLast && section < result.sections.size(); ++section) {
        const auto begin = lanes.lastRoot.begin() + static_cast<std::ptrdiff_t>(section * m_radii);
        const auto most = std::max_element(begin, begin + static_cast<std::ptrdiff_t>(m_radii));
        if (*most > 0) {
            const auto lane = static_cast<std::size_t>(most - lanes.lastRoot.begin());
            result.sections[section].lastCut =
                LastCut{.depth_mm = *most * *most,
                        .radius = static_cast<int>(lane % m_radii),
                        .at = unpack(lanes.lastPass[lane], result, section)};
        }
    }
}

} // namespace sparkout
