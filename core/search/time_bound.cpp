// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/time_bound.h"

#include "core/process/printed_form.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/process/wheel_wave.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

/// Rounding of t_П, Σa and times, generously [mm, share].
constexpr double boundRounding_mm = 1e-9, boundRounding = 1e-9;

/// The infeed that the bound assumes without a machine form.
double blankInfeed_mm(const Project& project, double total_mm) {
    const std::vector<ZoneBlank> zones = zoneBlanks(*project.part);
    const auto gauged = static_cast<std::size_t>(gaugeSection(project));
    if (project.gauge->control == Control::position || gauged >= zones.size()
        || zones[gauged].stock_mm >= 0) {
        return fedAtSize(project, total_mm);
    }
    return std::min(total_mm, project.part->stock_mm + zones[gauged].stock_mm);
}

/// The gauge may read the size this much before it is fed: by the form that the machine prints, and
/// by what a wheel out of true cuts deeper.
double sureInfeed_mm(const Project& project, double total_mm) {
    const double before_mm = project.gauge->control == Control::gauge
                                 ? mostOfDiameters_mm(project) + wheelAmplitude_mm(project)
                                 : 0;
    return depthAtEnd_mm(project, blankInfeed_mm(project, total_mm)) - before_mm;
}

} // namespace

TimeBound::TimeBound(const Project& project, const Grid& grid, double totalInfeed_mm)
    : m_total(sureInfeed_mm(project, totalInfeed_mm) - stageSlack_mm - boundRounding_mm)
    , m_shortLastStep(project.gauge->control == Control::position) {
    const Machine& machine = *project.machine;
    const double revolution_s = units::secondsPerMinute / machine.work_speed_rpm;
    for (const StageSetting& setting : grid.settings()) {
        Rate rate;
        rate.infeed_mm = infeedOf(project, setting);
        if (project.operation->travels) {
            const bool isContinuous = setting.continuousFeed_mm_min > 0;
            const double plunge_s_mm =
                isContinuous ? 0 : units::secondsPerMinute / machine.plunge_feed_mm_min;
            rate.fixed_s = strokesAndDwells_s(project, setting.axialFeed_mm_min);
            const ReversalFeeds reversals =
                reversalFeeds(machine.reversal_infeed, isContinuous ? 0 : rate.infeed_mm);
            rate.step_s = rate.fixed_s;
            for (const double infeed_mm : {reversals.entry_mm, reversals.exit_mm}) {
                rate.step_s +=
                    revolution_s * std::ceil(infeed_mm * plunge_s_mm / revolution_s - 1e-6);
            }
            rate.s_per_mm = rate.fixed_s / rate.infeed_mm + plunge_s_mm * (1 - boundRounding);
        } else {
            rate.fixed_s = rate.step_s = revolution_s;
            rate.s_per_mm = revolution_s / rate.infeed_mm;
        }
        rate.sparkOut_s = setting.sparkOut * rate.fixed_s;
        m_rates.push_back(rate);
    }
    readSparkOuts(grid);
    if (!m_shortLastStep && grid.sparkOut() == 0) {
        m_delay_s = gaugeDelay_s(project);
    }
    std::vector<double> own;
    for (const Rate& rate : m_rates) {
        own.push_back(rate.s_per_mm);
    }
    const std::vector<double> least =
        grid.overFollowers(own, std::numeric_limits<double>::infinity(),
                           [](double a, double b) { return std::min(a, b); });
    for (std::size_t s = 0; s < m_rates.size(); ++s) {
        m_rates[s].next_s_per_mm = std::min(m_rates[s].s_per_mm, least[s]);
    }
}

void TimeBound::readSparkOuts(const Grid& grid) {
    if (grid.sparkOut() == 0) {
        return;
    }
    m_mostLast_mm = grid.mostLast_mm() + boundRounding_mm;
    m_sparkOut_s = std::numeric_limits<double>::infinity();
    for (const Rate& rate : m_rates) {
        m_sparkOut_s = rate.sparkOut_s > 0 ? std::min(m_sparkOut_s, rate.sparkOut_s) : m_sparkOut_s;
    }
}

double TimeBound::rest_s(std::size_t setting, double fed_mm, double later_mm, bool last) const {
    const Rate& rate = m_rates[setting];
    const double left = last ? 0 : std::min(later_mm, m_mostLast_mm); // fed up to the spark-out
    const double all = m_total - left - fed_mm;
    if (rate.sparkOut_s > 0) {
        return 0;
    }
    if (all <= 0) {
        return last ? 0 : m_sparkOut_s * (1 - boundRounding);
    }
    if (last) {
        const double steps = std::ceil(all / rate.infeed_mm - boundRounding);
        const double whole = m_shortLastStep ? std::max(steps - 1, 0.0) : steps;
        return (whole * rate.step_s + (steps - whole) * rate.fixed_s + m_delay_s)
               * (1 - boundRounding);
    }
    const double here = std::max(all - later_mm, 0.0);
    return (here * rate.s_per_mm + (all - here) * rate.next_s_per_mm + m_sparkOut_s + m_delay_s)
           * (1 - boundRounding);
}

double infeedOf(const Project& project, const StageSetting& setting) {
    return setting.continuousFeed_mm_min > 0
               ? setting.continuousFeed_mm_min / units::secondsPerMinute
                     * strokesAndDwells_s(project, setting.axialFeed_mm_min)
               : project.operation.infeed_mm(setting.radial, project.machine->work_speed_rpm);
}

double leastTime_s(const Project& project, const Grid& grid) {
    const double total_mm = makeBlank(*project.part).totalInfeed_mm;
    const TimeBound bound(project, grid, total_mm);
    const double fed_mm = firstFeed(project, total_mm);
    double least_s = std::numeric_limits<double>::infinity();
    for (const std::size_t stages : grid.stageCounts()) {
        const bool single = stages == 1;
        const double later_mm = single ? 0 : grid.remainder(grid.leastTaken(stages, 0, 0));
        for (std::size_t s = 0; s < grid.settings().size(); ++s) {
            if (grid.mayHave(stages, 0, s)) {
                least_s = std::min(least_s, bound.rest_s(s, fed_mm, later_mm, single));
            }
        }
    }
    return least_s;
}

} // namespace sparkout
