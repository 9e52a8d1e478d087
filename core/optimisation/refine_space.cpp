// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/refine_space.h"

#include "core/optimisation/grid.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {
constexpr double refineSlack = 1e-9; ///< share by which a rounded value may miss its range
}

double RefineSpace::Setting::stepAt(double value) const {
    constexpr int digits = 3;
    return step > 0 ? step : std::pow(10.0, std::floor(std::log10(value)) + 1 - digits);
}

double RefineSpace::Setting::rounded(double value) const {
    const double by = stepAt(value);
    double steps = std::round((value - base) / by);
    const double slack = refineSlack * high;
    if (base + steps * by > high + slack) {
        --steps;
    } else if (base + steps * by < low - slack) {
        ++steps;
    }
    return asWritten(base + steps * by);
}

RefineSpace::RefineSpace(const Project& project, const Cycle& cycle)
    : m_cycle(cycle)
    , m_stock_mm(project.part.stock_mm)
    , m_leastLast_mm(refinedStock_mm)
    , m_mostLast_mm(project.part.stock_mm)
    , m_nonIncreasing(project.optimisation->non_increasing) {
    const Optimisation& asked = *project.optimisation;
    const MachineLimits& limits = project.machine.limits;
    if (project.operation == Operation::traverse) {
        addFeeds(&Stage::radial_feed_mm, asked.radial_feed_mm, limits.radial_feed_mm);
        addFeeds(&Stage::axial_feed_mm_min, asked.axial_feed_mm_min, limits.axial_feed_mm_min);
    } else {
        addFeeds(&Stage::radial_feed_mm_min, asked.radial_feed_mm_min, limits.plunge_feed_mm_min);
    }
    for (std::size_t z = 0; z + 1 < cycle.stages.size(); ++z) {
        m_settings.push_back({z, nullptr, refinedStock_mm, m_stock_mm, 0, refinedStock_mm});
    }
    if (asked.last_stock_mm && cycle.stages.size() > 1) {
        m_leastLast_mm = std::max(m_leastLast_mm, asked.last_stock_mm->front());
        m_mostLast_mm = asked.last_stock_mm->back();
    }
}

/// Between the levels of the grid, within the machine's range. What cannot be set otherwise stays.
void RefineSpace::addFeeds(std::optional<double> Stage::*feed, const Levels& levels,
                           const std::optional<std::vector<double>>& range) {
    const std::vector<double> values = levelValues(levels);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    Setting setting;
    setting.feed = feed;
    setting.low = *least;
    setting.high = *most;
    if (range && range->size() == 3) {
        setting.low = std::max(setting.low, (*range)[0]);
        setting.high = std::min(setting.high, (*range)[1]);
        setting.base = (*range)[2] > 0 ? (*range)[0] : 0;
        setting.step = (*range)[2];
    }
    const double middle = setting.rounded((setting.low + setting.high) / 2);
    const double slack = refineSlack * setting.high;
    if (setting.low >= setting.high || middle < setting.low - slack
        || middle > setting.high + slack) {
        return;
    }
    for (setting.stage = 0; setting.stage < m_cycle.stages.size(); ++setting.stage) {
        m_settings.push_back(setting);
    }
}

std::vector<double> RefineSpace::valuesOf(const Cycle& cycle) const {
    std::vector<double> values;
    for (const Setting& setting : m_settings) {
        const Stage& stage = cycle.stages[setting.stage];
        const double value = setting.isStock() ? stage.stock_mm : *(stage.*setting.feed);
        values.push_back(std::clamp(value, setting.low, setting.high));
    }
    return values;
}

std::optional<Cycle> RefineSpace::cycleOf(const std::vector<double>& values) const {
    Cycle cycle = m_cycle;
    double taken_mm = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Stage& stage = cycle.stages[m_settings[i].stage];
        if (m_settings[i].isStock()) {
            stage.stock_mm = values[i];
            taken_mm += values[i];
        } else {
            stage.*m_settings[i].feed = values[i];
        }
    }
    Stage& last = cycle.stages.back();
    last.stock_mm = asWritten(m_stock_mm - taken_mm);
    const double slack = refineSlack * m_stock_mm;
    if (last.stock_mm < m_leastLast_mm - slack || last.stock_mm > m_mostLast_mm + slack) {
        return std::nullopt;
    }
    for (std::size_t z = 1; m_nonIncreasing && z < cycle.stages.size(); ++z) {
        for (const auto feed :
             {&Stage::radial_feed_mm, &Stage::axial_feed_mm_min, &Stage::radial_feed_mm_min}) {
            if (cycle.stages[z].*feed > cycle.stages[z - 1].*feed) {
                return std::nullopt;
            }
        }
    }
    return cycle;
}

std::vector<double> RefineSpace::rounded(std::vector<double> values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = m_settings[i].rounded(values[i]);
    }
    return values;
}

} // namespace sparkout
