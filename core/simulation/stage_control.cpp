// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/stage_control.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

GaugeSignal::GaugeSignal(const Project& project, bool endsCycle)
    : m_end_s(gaugeDelay_s(project))
    , m_change_s(m_end_s + project.machine->feed_change_delay_s.value_or(0))
    , m_endsCycle(endsCycle && project.gauge->control == Control::gauge) {}

void GaugeSignal::read(double time_s, double remaining_mm) {
    if (m_change_s == 0) { // without a delay only the last one counts
        m_readings.assign(1, {time_s, remaining_mm});
        return;
    }
    m_readings.push_back({time_s, remaining_mm});
    const auto first = std::find_if(m_readings.begin(), m_readings.end(), [&](const Reading& each) {
        return each.time_s > time_s - m_change_s + delaySlack_s;
    });
    if (first - m_readings.begin() > 1) { // the newest of those that are old enough
        m_readings.erase(m_readings.begin(), first - 1);
    }
}

double GaugeSignal::knownBy(double least_mm, double delay_s) const {
    if (delay_s == 0 && !m_readings.empty()) {
        return least_mm + stageSlack_mm - m_readings.back().remaining_mm;
    }
    const auto oldEnough = [&](const Reading& each) {
        return each.time_s <= m_readings.back().time_s - delay_s + delaySlack_s;
    };
    const auto newest = std::find_if(m_readings.rbegin(), m_readings.rend(), oldEnough);
    return newest != m_readings.rend() ? least_mm + stageSlack_mm - newest->remaining_mm
                                       : -std::numeric_limits<double>::infinity();
}

double GaugeSignal::overBy(double later_mm, bool last) const {
    const double changes = knownBy(later_mm, last ? m_end_s : m_change_s);
    return m_endsCycle ? std::max(changes, knownBy(0, m_end_s)) : changes;
}

int lateSteps(const Project& project, double step_s) {
    const double late_s = gaugeDelay_s(project) + project.machine->feed_change_delay_s.value_or(0);
    return project.gauge->control == Control::gauge
               ? static_cast<int>(std::ceil(std::max(late_s - delaySlack_s, 0.0) / step_s))
               : 0;
}

std::vector<double> infeedsOfStages(const Project& project) {
    std::vector<double> feeds;
    for (const Stage& stage : project.cycle->stages) {
        feeds.push_back(
            project.operation.infeed_mm((stage.*project.operation->radial().value).value_or(0),
                                        project.machine->work_speed_rpm));
    }
    return feeds;
}

std::vector<double> fedByStep_mm(const Project& project) {
    std::vector<double> fed = infeedsOfStages(project);
    const Machine& machine = *project.machine;
    const double n = machine.work_speed_rpm;
    const double dwellTurns =
        2 * dwellRevolutions(machine.dwell_entry_s, n) + dwellRevolutions(machine.dwell_exit_s, n);
    const double travel_mm = project.part->length_mm - project.wheel->width_mm
                             + machine.overrun_entry_mm + machine.overrun_exit_mm;
    for (std::size_t z = 0; z < fed.size() && project.operation->travels; ++z) {
        const Stage& stage = project.cycle->stages[z];
        if (stage.continuousFeed_mm_min() > 0 && stage.axial_feed_mm_min) {
            // plunging in at either reversal takes whole revolutions
            const double turns =
                n * std::max(fed[z], 0.0) / machine.plunge_feed_mm_min + 2 + dwellTurns;
            fed[z] += stage.continuousFeed_mm_min()
                      * (turns / n + 2 * travel_mm / *stage.axial_feed_mm_min);
        }
    }
    return fed;
}

StageControl::StageControl(const Project& project, std::vector<double> feeds_mm,
                           double totalInfeed_mm)
    : m_feeds(std::move(feeds_mm))
    , m_stages(project.cycle->stages)
    , m_laterStock(m_feeds.size())
    , m_steps(m_feeds.size())
    , m_control(project.gauge->control)
    , m_fedAtSize_mm(fedAtSize(project, totalInfeed_mm))
    , m_gauge(project, !m_stages.empty() && !m_stages.back().sparkOutSteps()) {
    double later = 0;
    for (std::size_t z = m_feeds.size(); z-- > 0;) {
        m_laterStock[z] = later;
        later += project.cycle->stages[z].stock_mm;
    }
}

double StageControl::stageEndInfeed() const {
    return m_fedAtSize_mm - m_laterStock[m_stage];
}

double StageControl::nextInfeed(double fed_mm) const {
    if (!m_stages[m_stage].feeds()) {
        return 0;
    }
    if (m_control == Control::position) {
        return std::clamp(stageEndInfeed() - fed_mm, 0.0, m_feeds[m_stage]);
    }
    return m_feeds[m_stage];
}

double StageControl::mostFed() const {
    return m_control == Control::position ? stageEndInfeed()
                                          : std::numeric_limits<double>::infinity();
}

bool StageControl::waitsForSize() const {
    return m_stages[m_stage].waitsForSize();
}

bool StageControl::retracts() const {
    return m_stages[m_stage].feeds() && m_feeds[m_stage] < 0;
}

double StageControl::overBy(double fed_mm) const {
    constexpr double always = std::numeric_limits<double>::infinity();
    const Stage& stage = m_stages[m_stage];
    if (const auto steps = stage.sparkOutSteps()) {
        return m_steps[m_stage] >= *steps ? always : -always;
    }
    if (m_control == Control::position && stage.feeds()) {
        return fed_mm >= stageEndInfeed() - stageSlack_mm ? always : -always;
    }
    return m_gauge.overBy(m_laterStock[m_stage], m_stage + 1 == m_stages.size());
}

void StageControl::read(double remainingStock_mm, double time_s) {
    ++m_steps[m_stage];
    m_gauge.read(time_s, remainingStock_mm);
}

void StageControl::stepDone(double remainingStock_mm, double fed_mm, double time_s) {
    read(remainingStock_mm, time_s);
    while (!finished() && overBy(fed_mm) >= 0) {
        endStage();
    }
}

namespace {

/// `depthOf(i)` is depth_k + depth_{k+K/2} of the i-th of `count` diameters.
template <class DepthOf>
double remainingOf(int count, GaugeRule rule, double sizeDepth_mm, const DepthOf& depthOf) {
    // D_k/2 is (depth_k + depth_{k+K/2})/2 beyond first touch, for shafts and bores; the smallest
    // diameter of a shaft and the largest of a bore are the deepest.
    double deepest = depthOf(0);
    double shallowest = deepest;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double depth = depthOf(i);
        deepest = std::max(deepest, depth);
        shallowest = std::min(shallowest, depth);
        sum += depth;
    }
    switch (rule) {
    case GaugeRule::min: return sizeDepth_mm - deepest / 2;
    case GaugeRule::max: return sizeDepth_mm - shallowest / 2;
    case GaugeRule::mean: break;
    }
    return sizeDepth_mm - sum / count / 2;
}

} // namespace

double remainingStock(const double* depth_mm, int radii, GaugeRule rule, double sizeDepth_mm) {
    const int half = radii / 2;
    return remainingOf(half, rule, sizeDepth_mm,
                       [&](int k) { return depth_mm[k] + depth_mm[k + half]; });
}

double remainingStock(const double* depth_mm, int radii, std::span<const std::size_t> diameters,
                      GaugeRule rule, double sizeDepth_mm) {
    const int half = radii / 2;
    return remainingOf(static_cast<int>(diameters.size()), rule, sizeDepth_mm, [&](int i) {
        const double* const one = depth_mm + diameters[static_cast<std::size_t>(i)];
        return one[0] + one[half];
    });
}

double depthAtEnd_mm(const Project& project, double totalInfeed_mm) {
    return project.gauge->control == Control::gauge ? totalInfeed_mm + deeperAtSize_mm(project)
                                                    : totalInfeed_mm;
}

double standsBack_mm(const Project& project) {
    return project.gauge->control == Control::position
               ? project.wheel->radius_wear_um / units::umPerMm
               : 0;
}

double fedAtSize(const Project& project, double totalInfeed_mm) {
    return totalInfeed_mm - standsBack_mm(project);
}

double firstFeed(const Project& project, double totalInfeed_mm) {
    const Gauge& gauge = *project.gauge;
    const double touch_mm =
        gauge.control == Control::position && gauge.datum_mm ? totalInfeed_mm - *gauge.datum_mm : 0;
    return touch_mm - standsBack_mm(project);
}

} // namespace sparkout
