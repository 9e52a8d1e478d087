// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/gauge_signal.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"

#include <algorithm>
#include <limits>

namespace sparkout {

GaugeSignal::GaugeSignal(const Project& project, bool endsCycle)
    : m_end_s(project.gauge->delay_s.value_or(0))
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

} // namespace sparkout
