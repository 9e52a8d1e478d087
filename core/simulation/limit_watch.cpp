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

void LimitWatch::prepare(const Lanes& lanes) {
    if (m_keepsLast) {
        const std::size_t count = lanes.depth_mm.size(), sections = count / m_radii;
        m_last = {};
        m_last.before_mm = lanes.depth_mm;
        m_last.taken_mm.assign(count, 0.0);
        m_last.pressed_mm.assign(count, 0.0);
        m_last.at.assign(sections, {});
        m_last.begun.assign(sections, {});
        m_last.hasBegun.assign(sections, 0);
    }
}

void LimitWatch::placeStep(std::size_t first, std::size_t count, const Place* places) {
    for (std::size_t section = first; section < first + count; ++section) {
        if (!std::exchange(m_last.hasBegun[section], 1)) {
            m_last.begun[section] = places[section - first];
        }
    }
}

// A lane that a step with infeed does not cut keeps the removal of the previous one, which made its
// surface.
void LimitWatch::keepStep(const Lanes& lanes, const Step& step) {
    constexpr double rounding = 1e-9; // rounding of an infeed
    LastStep& last = m_last;
    const bool feeds = step.infeed_mm > 0;
    const bool isShort =
        feeds && step.stage == last.stage && step.infeed_mm < last.infeed_mm * (1 - rounding);
    const bool isWhole = feeds && !isShort;
    const double* const depth_mm = lanes.depth_mm.data();
    double* const before_mm = last.before_mm.data();
    double* const taken_mm = last.taken_mm.data();
    double* const pressed_mm = last.pressed_mm.data();
    const double* const share = lanes.share.data();
    const std::size_t count = lanes.depth_mm.size();
    const double spiral_mm = step.isSpiral ? step.infeed_mm : 0;
    const bool waves = !lanes.waveCos.empty();
    for (std::size_t lane = 0; lane < count; ++lane) {
        const double taken = depth_mm[lane] - before_mm[lane];
        const double stood = step.fed_mm - spiral_mm * (1 - share[lane]) - before_mm[lane];
        const double pressed = waves ? std::max(stood, taken) : stood; // t_П leaves out the wave
        const double kept = taken_mm[lane];
        const bool isNewer = isWhole   ? taken > 0
                             : isShort ? taken > kept
                                       : taken > 0 && !(kept > 0);
        taken_mm[lane] = isNewer ? taken : kept;
        pressed_mm[lane] = isNewer ? pressed : pressed_mm[lane];
        before_mm[lane] = depth_mm[lane];
    }
    if (isWhole) {
        last.stage = step.stage;
        last.infeed_mm = step.infeed_mm;
    }
    if (isWhole || !(last.duration_s > 0)) {
        last.duration_s = step.duration_s;
        last.overlap = step.overlap;
        last.at.swap(last.begun);
    }
    last.sparkOut_s = feeds ? 0 : last.sparkOut_s + step.duration_s;
    std::ranges::fill(last.hasBegun, 0);
}

void LimitWatch::judge(const Lanes& lanes, const PassRange& range, double root,
                       const PassFeed& feed, const Place* places) {
    const double fed = feed.greatest();
    if (fed > m_quietEnd) {
        constexpr double quietReach = 0.05; ///< share of the whole infeed
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

/// Fits a polynomial from the greatest stock left down to below the stock that this pass may leave,
/// as far as one polynomial is accurate. Radii only grow deeper, so none leaves the stretch at its
/// upper end. The curve bends more for less stock, so a range that failed once is not tried again.
void LimitWatch::openStretch(const Lanes& lanes, double fed_mm) {
    constexpr double leastSpread = 1e-3; ///< share of the whole infeed
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
        if (root[i] > m_quietRoot) { // otherwise no new worst
            most = std::max(most, m_burn->usage(root[i], m_total - depth_mm[i]));
        }
    }
    return most;
}

/// Keeps the worst visit of this pass.
void LimitWatch::keep(const Lanes& lanes, const PassRange& range, const Place* places) {
    const std::size_t end = range.first + range.count;
    if (m_lane < range.first || m_lane >= end || usage(lanes, m_lane) != m_usage) {
        m_lane = range.first; // mostly the same lane as before
        while (m_lane + 1 < end && usage(lanes, m_lane) != m_usage) {
            ++m_lane;
        }
    }
    std::size_t zone = 0, radius = m_lane - range.first;
    for (; radius >= m_radii; radius -= m_radii) { // few zones: a division would be slower
        ++zone;
    }
    m_worst = {.depth_mm = lanes.root[m_lane] * lanes.root[m_lane],
               .stock_mm = std::max(0.0, m_total - lanes.depth_mm[m_lane]),
               .radius = static_cast<int>(radius),
               .at = places[zone]};
}

void LimitWatch::put(SimulationResult& result) const {
    if (m_burn && m_usage > 0) {
        result.burn = m_worst;
    }
    std::vector<SectionResult>& sections =
        result.zoneSections.empty() ? result.sections : result.zoneSections;
    const std::size_t first = result.zoneSections.empty() ? 0 : result.sections.size();
    for (std::size_t i = 0; m_keepsLast && i < sections.size(); ++i) {
        const auto begin =
            m_last.taken_mm.begin() + static_cast<std::ptrdiff_t>((first + i) * m_radii);
        const auto most = std::max_element(begin, begin + static_cast<std::ptrdiff_t>(m_radii));
        if (*most > 0) {
            const auto lane = static_cast<std::size_t>(most - m_last.taken_mm.begin());
            sections[i].lastCut = LastCut{.depth_mm = *most,
                                          .overlap = m_last.overlap,
                                          .pressed_mm = m_last.pressed_mm[lane],
                                          .step_s = m_last.duration_s,
                                          .sparkOut_s = m_last.sparkOut_s,
                                          .radius = static_cast<int>(most - begin),
                                          .at = m_last.at[first + i]};
        }
    }
}

} // namespace sparkout
