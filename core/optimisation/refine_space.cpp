// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/refine_space.h"

#include "core/optimisation/grid.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {
constexpr double refineSlack = 1e-9; ///< relative tolerance at the ends of a range
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

RefineSpace::RefineSpace(const Project& project, Cycle cycle)
    : m_operation(project.operation)
    , m_cycle(std::move(cycle))
    , m_stock_mm(project.part->stock_mm)
    , m_leastLast_mm(refinedStock_mm)
    , m_mostLast_mm(project.part->stock_mm)
    , m_nonIncreasing(project.optimisation->non_increasing) {
    const Optimisation& asked = *project.optimisation;
    for (const StageFeed* feed : m_operation->searchedFeeds()) {
        addFeeds(*feed, asked, project.machine->limits);
    }
    addStocks(asked);
}

void RefineSpace::addStocks(const Optimisation& asked) {
    const std::size_t stages = m_cycle.stages.size();
    const NumberRows& rows = asked.stage_stock_mm;
    for (std::size_t z = 0; z + 1 < stages; ++z) {
        Setting stock{z, nullptr, refinedStock_mm, m_stock_mm, 0, refinedStock_mm};
        if (rows && z < rows->size()) {
            stock.low = std::max(stock.low, (*rows)[z][0]);
            stock.high = std::min(stock.high, (*rows)[z][1]);
        }
        if (stock.low < stock.high) {
            m_settings.push_back(stock);
        }
    }
    if (!m_cycle.stages.back().feeds()) {
        m_leastLast_mm = 0;
    }
    if (asked.last_stock_mm && stages > 1) {
        m_leastLast_mm = std::max(m_leastLast_mm, asked.last_stock_mm->front());
        m_mostLast_mm = asked.last_stock_mm->back();
    }
    if (rows && rows->size() >= stages) {
        m_leastLast_mm = std::max(m_leastLast_mm, (*rows)[stages - 1][0]);
        m_mostLast_mm = std::min(m_mostLast_mm, (*rows)[stages - 1][1]);
    }
}

/// Adds feeds between the levels of the grid, within the machine's range. A feed with a single
/// value is fixed.
void RefineSpace::addFeeds(const StageFeed& feed, const Optimisation& asked,
                           const MachineLimits& limits) {
    const auto& range = limits.*feed.range;
    const NumberRows& byStage = asked.*feed.byStage;
    const std::vector<double> values = levelValues(asked.*feed.levels);
    if (values.empty()) {
        return;
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    Setting setting;
    setting.feed = feed.value;
    setting.low = *least;
    setting.high = *most;
    if (range && range->size() == 3) {
        setting.low = std::max(setting.low, (*range)[0]);
        setting.high = std::min(setting.high, (*range)[1]);
        setting.base = (*range)[2] > 0 ? (*range)[0] : 0;
        setting.step = (*range)[2];
    }
    for (std::size_t z = 0; z < m_cycle.stages.size(); ++z) {
        Setting own = setting;
        own.stage = z;
        if (byStage && z < byStage->size()) {
            own.low = std::max(own.low, (*byStage)[z][0]);
            own.high = std::min(own.high, (*byStage)[z][1]);
        }
        const double middle = own.rounded((own.low + own.high) / 2);
        const double slack = refineSlack * own.high;
        if ((m_cycle.stages[z].*feed.value).value_or(0) > 0 && own.low < own.high
            && middle >= own.low - slack && middle <= own.high + slack) {
            m_settings.push_back(own);
        }
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
        } else {
            stage.*m_settings[i].feed = values[i];
        }
    }
    for (std::size_t z = 0; z + 1 < cycle.stages.size(); ++z) {
        taken_mm += cycle.stages[z].stock_mm;
    }
    Stage& last = cycle.stages.back();
    last.stock_mm = asWritten(m_stock_mm - taken_mm);
    const double slack = refineSlack * m_stock_mm;
    if (last.stock_mm < m_leastLast_mm - slack || last.stock_mm > m_mostLast_mm + slack) {
        return std::nullopt;
    }
    for (std::size_t z = 1; m_nonIncreasing && z < cycle.stages.size(); ++z) {
        for (const StageFeed* feed : m_operation->searchedFeeds()) {
            const std::optional<double>& own = cycle.stages[z].*feed->value;
            if (own && *own > (cycle.stages[z - 1].*feed->value).value_or(*own)) {
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
