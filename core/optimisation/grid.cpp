// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sparkout {

double asWritten(double value) {
    constexpr double decimals = 1e10, lastBits = 1e-9;
    const double written = std::round(value * decimals) / decimals;
    return std::abs(written - value) <= lastBits * std::abs(value) ? written : value;
}

std::vector<double> levelValues(const Levels& levels) {
    if (const auto* list = std::get_if<std::vector<double>>(&levels)) {
        return *list;
    }
    std::vector<double> values;
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        if (stepped->step <= 0) {
            return {stepped->from};
        }
        const double count = std::floor((stepped->to - stepped->from) / stepped->step + 1e-6);
        for (int i = 0; i <= count; ++i) {
            values.push_back(asWritten(stepped->from + i * stepped->step));
        }
    }
    return values;
}

namespace {

double levelCount(const Levels& levels) {
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels); stepped && stepped->step > 0) {
        return std::floor((stepped->to - stepped->from) / stepped->step + 1e-6) + 1;
    }
    return static_cast<double>(levelValues(levels).size());
}

} // namespace

Grid::Grid(const Project& project)
    : m_operation(project.operation), m_stock_mm(project.part.stock_mm), m_fault(read(project)) {}

GridFault Grid::read(const Project& project) {
    if (!project.optimisation) {
        return GridFault::notGiven;
    }
    const Optimisation& asked = *project.optimisation;
    const bool traverse = m_operation == Operation::traverse;
    const Levels& radial = traverse ? asked.radial_feed_mm : asked.radial_feed_mm_min;
    const Levels axial = traverse ? asked.axial_feed_mm_min : Levels{std::vector<double>{0}};
    const double settings = levelCount(radial) * levelCount(axial);
    const double steps = std::max(0.0, std::ceil(m_stock_mm / asked.stock_step_mm - 1e-9) - 1);
    if (settings < 1) {
        return GridFault::noLevels;
    }
    if (settings > mostSettings) {
        return GridFault::tooManyLevels;
    }
    if (steps > mostStockSteps) {
        return GridFault::tooManySteps;
    }
    m_step_mm = asked.stock_step_mm;
    m_steps = static_cast<int>(steps);
    if (asked.last_stock_mm) {
        const auto stepsTo = [this](double left_mm) { return (m_stock_mm - left_mm) / m_step_mm; };
        const double most = std::floor(stepsTo((*asked.last_stock_mm)[0]) + 1e-6);
        const double least = std::ceil(stepsTo((*asked.last_stock_mm)[1]) - 1e-6);
        m_steps = static_cast<int>(std::clamp(most, 0.0, steps));
        m_leastSteps = static_cast<int>(std::clamp(least, 0.0, steps + 1));
    }
    m_nonIncreasing = asked.non_increasing;
    for (const double radialFeed : levelValues(radial)) {
        for (const double axialFeed : levelValues(axial)) {
            m_settings.push_back({radialFeed, axialFeed});
        }
    }
    for (const double number : asked.stages) {
        const auto count = static_cast<std::size_t>(number);
        const bool known =
            std::find(m_stageCounts.begin(), m_stageCounts.end(), count) != m_stageCounts.end();
        const bool divides =
            count == 1 || std::max(static_cast<int>(count) - 1, m_leastSteps) <= m_steps;
        if (!known && count >= 1 && divides) {
            m_stageCounts.push_back(count);
        }
    }
    return m_stageCounts.empty() ? GridFault::noDivision : GridFault::none;
}

bool Grid::mayFollow(std::size_t first, std::size_t second) const {
    const FeedSetting& a = m_settings[first];
    const FeedSetting& b = m_settings[second];
    return !m_nonIncreasing || (b.radial <= a.radial && b.axialFeed_mm_min <= a.axialFeed_mm_min);
}

std::int64_t Grid::size() const {
    double total = 0;
    for (const std::size_t stages : m_stageCounts) {
        std::vector<double> ways(m_settings.size(), 1.0); // of setting stages up to this one
        double splits = 1,
               tooFew = stages > 1 ? 1 : 0; // ways to share m_steps, and fewer than least
        for (std::size_t z = 1; z < stages; ++z) {
            std::vector<double> longer(m_settings.size(), 0.0);
            for (std::size_t a = 0; a < m_settings.size(); ++a) {
                for (std::size_t b = 0; b < m_settings.size(); ++b) {
                    longer[b] += mayFollow(a, b) ? ways[a] : 0;
                }
            }
            ways = longer;
            const auto parts = static_cast<double>(z);
            splits = splits * (m_steps - parts + 1) / parts;
            tooFew = tooFew * std::max(0.0, m_leastSteps - parts) / parts;
        }
        total += (splits - tooFew) * std::accumulate(ways.begin(), ways.end(), 0.0);
    }
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    return total < 9e18 ? std::llround(total) : most;
}

namespace {

int stepsTaken(const GridCycle& cycle) {
    int taken = 0;
    for (const GridStage& stage : cycle) {
        taken += stage.steps;
    }
    return taken;
}

} // namespace

// Any setting may follow itself and each stage but the last leaves a step for those to come, so
// what is begun can always be completed.
bool Grid::complete(GridCycle& cycle, std::size_t stages) const {
    while (cycle.size() < stages) {
        std::size_t setting = 0;
        while (!cycle.empty() && !mayFollow(cycle.back().setting, setting)) {
            ++setting;
        }
        cycle.push_back({setting, 0});
        if (cycle.size() < stages) {
            cycle.back().steps = leastOf(stages - cycle.size() + 1, stepsTaken(cycle));
        }
    }
    return true;
}

bool Grid::advance(GridCycle& cycle) const {
    const std::size_t stages = cycle.size();
    while (!cycle.empty()) {
        const std::size_t z = cycle.size() - 1;
        GridStage& stage = cycle.back();
        if (z + 1 < stages) {
            const int between = static_cast<int>(stages - z) - 2; // stages up to the last
            if (stepsTaken(cycle) + between < m_steps) {
                ++stage.steps;
                return complete(cycle, stages);
            }
        }
        for (++stage.setting; stage.setting < m_settings.size(); ++stage.setting) {
            if (z == 0 || mayFollow(cycle[z - 1].setting, stage.setting)) {
                stage.steps = 0;
                stage.steps = z + 1 < stages ? leastOf(stages - z, stepsTaken(cycle)) : 0;
                return complete(cycle, stages);
            }
        }
        cycle.pop_back();
    }
    return false;
}

bool Grid::next(GridCycle& cycle) const {
    auto count = m_stageCounts.begin();
    if (!cycle.empty()) {
        count = std::find(m_stageCounts.begin(), m_stageCounts.end(), cycle.size());
        if (advance(cycle)) {
            return true;
        }
        ++count;
    }
    return count != m_stageCounts.end() && complete(cycle, *count);
}

bool Grid::before(const GridCycle& a, const GridCycle& b) const {
    if (a.size() != b.size()) {
        return std::find(m_stageCounts.begin(), m_stageCounts.end(), a.size())
               < std::find(m_stageCounts.begin(), m_stageCounts.end(), b.size());
    }
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(), [](const GridStage& x, const GridStage& y) {
            return x.setting != y.setting ? x.setting < y.setting : x.steps < y.steps;
        });
}

Cycle Grid::cycle(const GridCycle& cycle) const {
    Cycle stated;
    int taken = 0;
    for (const GridStage& each : cycle) {
        const FeedSetting& setting = m_settings[each.setting];
        Stage stage;
        if (m_operation == Operation::traverse) {
            stage.radial_feed_mm = setting.radial;
            stage.axial_feed_mm_min = setting.axialFeed_mm_min;
        } else {
            stage.radial_feed_mm_min = setting.radial;
        }
        const bool last = stated.stages.size() + 1 == cycle.size();
        stage.stock_mm = last ? remainder(taken) : asWritten(each.steps * m_step_mm);
        taken += each.steps;
        stated.stages.push_back(stage);
    }
    return stated;
}

} // namespace sparkout
