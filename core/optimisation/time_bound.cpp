// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/time_bound.h"

#include "core/simulation/cycle_steps.h"
#include "core/simulation/stage_control.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

/// Rounding of t_П, Σa and times, generously [mm, share].
constexpr double boundRounding_mm = 1e-9, boundRounding = 1e-9;

} // namespace

TimeBound::TimeBound(const Project& project, const Grid& grid, double totalInfeed_mm)
    : m_total(totalInfeed_mm - stageSlack_mm - boundRounding_mm)
    , m_shortLastStep(project.gauge.control == Control::position) {
    const Machine& machine = project.machine;
    const double revolution_s = units::secondsPerMinute / machine.work_speed_rpm;
    for (const FeedSetting& setting : grid.settings()) {
        Rate rate;
        if (project.operation == Operation::traverse) {
            const double travel = project.part.length_mm - project.wheel.width_mm
                                  + machine.overrun_entry_mm + machine.overrun_exit_mm;
            const double dwells =
                2 * dwellRevolutions(machine.dwell_entry_s, machine.work_speed_rpm)
                + dwellRevolutions(machine.dwell_exit_s, machine.work_speed_rpm);
            const double plunge_s_mm = units::secondsPerMinute / machine.plunge_feed_mm_min;
            rate.infeed_mm = setting.radial;
            rate.fixed_s = dwells * revolution_s
                           + 2 * travel / setting.axialFeed_mm_min * units::secondsPerMinute;
            rate.step_s =
                rate.fixed_s
                + revolution_s * std::ceil(rate.infeed_mm * plunge_s_mm / revolution_s - 1e-6);
            rate.s_per_mm = rate.fixed_s / rate.infeed_mm + plunge_s_mm * (1 - boundRounding);
        } else {
            rate.infeed_mm = setting.radial / machine.work_speed_rpm;
            rate.fixed_s = rate.step_s = revolution_s;
            rate.s_per_mm = revolution_s / rate.infeed_mm;
        }
        m_rates.push_back(rate);
    }
    for (std::size_t s = 0; s < m_rates.size(); ++s) {
        m_rates[s].next_s_per_mm = m_rates[s].s_per_mm;
        for (std::size_t t = 0; t < m_rates.size(); ++t) {
            if (grid.mayFollow(s, t)) {
                m_rates[s].next_s_per_mm = std::min(m_rates[s].next_s_per_mm, m_rates[t].s_per_mm);
            }
        }
    }
}

double TimeBound::rest_s(std::size_t setting, double fed_mm, double later_mm, bool last) const {
    const Rate& rate = m_rates[setting];
    const double all = m_total - fed_mm;
    if (all <= 0) {
        return 0;
    }
    if (last) {
        const double steps = std::ceil(all / rate.infeed_mm - boundRounding);
        const double whole = m_shortLastStep ? std::max(steps - 1, 0.0) : steps;
        return (whole * rate.step_s + (steps - whole) * rate.fixed_s) * (1 - boundRounding);
    }
    const double here = std::max(all - later_mm, 0.0);
    return (here * rate.s_per_mm + (all - here) * rate.next_s_per_mm) * (1 - boundRounding);
}

} // namespace sparkout
