// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/gauge_signal.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"

#include <algorithm>

namespace sparkout {

GaugeSignal::GaugeSignal(const Project& project, bool endsCycle)
    : m_end_s(project.gauge->delay_s.value_or(0))
    , m_change_s(m_end_s + project.machine->feed_change_delay_s.value_or(0))
    , m_endsCycle(endsCycle && project.gauge->control == Control::gauge) {}

void GaugeSignal::read(double time_s, double remaining_mm) {
    m_readings.push_back({time_s, remaining_mm});
    const auto first = std::find_if(m_readings.begin(), m_readings.end(), [&](const Reading& each) {
        return each.time_s > time_s - m_change_s + delaySlack_s;
    });
    if (first - m_readings.begin() > 1) { // of those that are old enough the newest counts
        m_readings.erase(m_readings.begin(), first - 1);
    }
}

bool GaugeSignal::isKnown(double least_mm, double delay_s) const {
    const auto oldEnough = [&](const Reading& each) {
        return each.time_s <= m_readings.back().time_s - delay_s + delaySlack_s;
    };
    const auto newest = std::find_if(m_readings.rbegin(), m_readings.rend(), oldEnough);
    return newest != m_readings.rend() && newest->remaining_mm <= least_mm + stageSlack_mm;
}

bool GaugeSignal::isOver(double later_mm, bool last) const {
    return isKnown(later_mm, last ? m_end_s : m_change_s) || (m_endsCycle && isKnown(0, m_end_s));
}

bool GaugeSignal::isDue(double later_mm) const {
    return isKnown(later_mm, 0);
}

} // namespace sparkout
