// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/grid.h"

#include "core/project/cycle.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

double levelCount(const Levels& levels) {
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels); stepped && stepped->step > 0) {
        return std::max(std::floor((stepped->to - stepped->from) / stepped->step + 1e-6) + 1, 0.0);
    }
    return static_cast<double>(levelValues(levels).size());
}

Grid::Grid(const Project& project)
    : m_operation(project.operation), m_stock_mm(project.part->stock_mm), m_fault(read(project)) {}

GridFault Grid::read(const Project& project) {
    if (!project.optimisation) {
        return GridFault::notGiven;
    }
    const Optimisation& asked = *project.optimisation;
    double settings = levelCount(asked.*m_operation->radial().levels);
    double axials = 1;
    if (const StageFeed* const axial = m_operation->axial()) {
        axials = levelCount(asked.*axial->levels);
    }
    if (const StageFeed* const continuous = m_operation->continuous; continuous && settings > 0) {
        settings += levelCount(asked.*continuous->levels);
    }
    settings *= axials;
    m_step_mm = asked.stock_step_mm;
    const std::vector<double> counts = levelCount(asked.unfed_steps) > mostVariants
                                           ? std::vector<double>{}
                                           : levelValues(asked.unfed_steps);
    m_sparkOut = counts.empty() ? 0 : static_cast<int>(counts.front());
    const double whole = m_stock_mm / asked.stock_step_mm;
    const double steps = m_sparkOut == 0        ? std::max(0.0, std::ceil(whole - 1e-9) - 1)
                         : asked.stage_stock_mm ? std::floor(whole + 1e-9)
                                                : std::ceil(whole - 1e-9);
    if (settings < 1) {
        return GridFault::noLevels;
    }
    if (settings > mostSettings) {
        return GridFault::tooManyLevels;
    }
    if (steps > mostStockSteps) {
        return GridFault::tooManySteps;
    }
    m_steps = static_cast<int>(steps);
    m_nonIncreasing = asked.non_increasing;
    m_bounded = asked.stage_stock_mm
                || std::ranges::any_of(m_operation->searchedFeeds(), [&asked](const auto* feed) {
                       return (asked.*feed->byStage).has_value();
                   });
    readSettings(asked);
    for (const double number : asked.stages) {
        const std::size_t count = static_cast<std::size_t>(number) + (m_sparkOut > 0 ? 1 : 0);
        const bool known =
            std::find(m_stageCounts.begin(), m_stageCounts.end(), count) != m_stageCounts.end();
        if (!known && number >= 1 && readShape(asked, count)) {
            m_stageCounts.push_back(count);
        }
    }
    return m_stageCounts.empty() ? GridFault::noDivision : GridFault::none;
}

void Grid::readSettings(const Optimisation& asked) {
    const StageFeed* const axialOf = m_operation->axial();
    const std::vector<double> axial =
        axialOf ? levelValues(asked.*axialOf->levels) : std::vector<double>{0};
    for (const double radialFeed : levelValues(asked.*m_operation->radial().levels)) {
        for (const double axialFeed : axial) {
            m_settings.push_back({radialFeed, axialFeed, 0});
        }
    }
    if (const StageFeed* const continuous = m_operation->continuous) {
        for (const double feed : levelValues(asked.*continuous->levels)) {
            for (const double axialFeed : axial) {
                m_settings.push_back({0, axialFeed, 0, feed});
            }
        }
    }
    for (const double axialFeed : axial) {
        if (m_sparkOut > 0) {
            m_settings.push_back({0, axialFeed, m_sparkOut});
        }
    }
    rankSettings();
}

void Grid::rankSettings() {
    const auto rank = [this](double StageSetting::*feed, std::vector<std::size_t>& ranks) {
        std::vector<double> values;
        for (const StageSetting& setting : m_settings) {
            values.push_back(setting.*feed);
        }
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
        for (const StageSetting& setting : m_settings) {
            const auto at = std::lower_bound(values.begin(), values.end(), setting.*feed);
            ranks.push_back(static_cast<std::size_t>(at - values.begin()));
        }
        return values.size();
    };
    m_radials = rank(&StageSetting::radial, m_radialRanks);
    m_axials = rank(&StageSetting::axialFeed_mm_min, m_axialRanks);
    std::vector<std::size_t> continuous;
    m_infeeds = m_radials + rank(&StageSetting::continuousFeed_mm_min, continuous) - 1;
    for (std::size_t s = 0; s < m_settings.size(); ++s) {
        m_radialRanks[s] = continuous[s] > 0 ? m_radials + continuous[s] - 1 : m_radialRanks[s];
    }
}

Grid Grid::withSparkOut(int count) const {
    Grid other = *this;
    other.m_sparkOut = count;
    for (StageSetting& setting : other.m_settings) {
        setting.sparkOut = setting.sparkOut > 0 ? count : 0;
    }
    return other;
}

bool Grid::readShape(const Optimisation& asked, std::size_t stages) {
    Shape shape;
    shape.least.assign(stages, 1);
    shape.most.assign(stages, m_steps);
    shape.allowed.assign(stages, std::vector<char>(m_settings.size(), 0));
    readStocks(asked, shape);
    if (!readFeeds(asked, shape)) {
        return false;
    }
    for (std::size_t z = 0; z + 1 < stages; ++z) {
        if (shape.least[z] > shape.most[z]) {
            return false;
        }
    }
    const bool possible = stages == 1
                              ? shape.leastBefore <= 0 && shape.mostBefore >= 0
                              : shape.leastBefore <= shape.mostBefore
                                    && shape.least[0] + shape.leastAfter[0] <= shape.mostBefore
                                    && shape.most[0] + shape.mostAfter[0] >= shape.leastBefore;
    m_shapes.resize(std::max(m_shapes.size(), stages + 1));
    m_shapes[stages] = std::move(shape);
    return possible;
}

// The bounds of the last stage limit the steps taken before it.
void Grid::readStocks(const Optimisation& asked, Shape& shape) const {
    constexpr double slack = 1e-6;
    const std::size_t stages = shape.least.size();
    shape.mostBefore = stages == 1 ? 0 : m_steps;
    const auto bound = [&](double least_mm, double most_mm) {
        const double most =
            least_mm <= 0 ? m_steps : std::max((m_stock_mm - least_mm) / m_step_mm, -1.0);
        const double least = std::max((m_stock_mm - most_mm) / m_step_mm, 0.0);
        shape.mostBefore = std::min(shape.mostBefore, static_cast<int>(std::floor(most + slack)));
        shape.leastBefore = std::max(shape.leastBefore, static_cast<int>(std::ceil(least - slack)));
    };
    if (asked.last_stock_mm && stages > 1) {
        bound((*asked.last_stock_mm)[0], (*asked.last_stock_mm)[1]);
    }
    const std::size_t rows = asked.stage_stock_mm ? asked.stage_stock_mm->size() : 0;
    for (std::size_t z = 0; z < std::min(rows, stages); ++z) {
        const std::vector<double>& row = (*asked.stage_stock_mm)[z];
        if (z + 1 == stages) {
            bound(row[0], row[1]);
        } else {
            const double most = std::min(row[1] / m_step_mm, static_cast<double>(m_steps));
            const double least = std::min(row[0] / m_step_mm, m_steps + 1.0);
            shape.least[z] = std::max(1, static_cast<int>(std::ceil(least - slack)));
            shape.most[z] = static_cast<int>(std::floor(most + slack));
        }
    }
    shape.leastAfter.assign(stages, 0);
    shape.mostAfter.assign(stages, 0);
    for (std::size_t z = stages - 1; z-- > 0;) {
        const bool beforeLast = z + 2 == stages;
        shape.leastAfter[z] = beforeLast ? 0 : shape.leastAfter[z + 1] + shape.least[z + 1];
        shape.mostAfter[z] = beforeLast ? 0 : shape.mostAfter[z + 1] + shape.most[z + 1];
    }
}

// Stage by stage from the last one on: a setting must have one that may follow it.
bool Grid::readFeeds(const Optimisation& asked, Shape& shape) const {
    const auto within = [](const NumberRows& rows, std::size_t z, double value) {
        constexpr double slack = 1e-9;
        return !rows || z >= rows->size()
               || (value >= (*rows)[z][0] * (1 - slack) && value <= (*rows)[z][1] * (1 + slack));
    };
    const NumberRows& radial = asked.*m_operation->radial().byStage;
    const StageFeed* const axial = m_operation->axial();
    const StageFeed* const continuous = m_operation->continuous;
    const auto isFedWithin = [&](std::size_t z, const StageSetting& setting) {
        return setting.continuousFeed_mm_min > 0
                   ? within(asked.*continuous->byStage, z, setting.continuousFeed_mm_min)
                   : within(radial, z, setting.radial);
    };
    const std::size_t stages = shape.allowed.size();
    for (std::size_t z = stages; z-- > 0;) {
        bool any = false;
        const bool sparks = z + 1 == stages && m_sparkOut > 0;
        const bool looksOn = m_nonIncreasing && z + 1 < stages && (m_bounded || m_sparkOut > 0);
        const std::vector<char> goesOn =
            looksOn ? overFollowers(shape.allowed[z + 1], char{0},
                                    [](char a, char b) { return std::max(a, b); })
                    : std::vector<char>(m_settings.size(), 1);
        for (std::size_t s = 0; s < m_settings.size(); ++s) {
            const StageSetting& setting = m_settings[s];
            const bool may =
                goesOn[s] != 0 && sparks == (setting.sparkOut > 0)
                && (sparks || isFedWithin(z, setting))
                && (!axial || within(asked.*axial->byStage, z, setting.axialFeed_mm_min));
            shape.allowed[z][s] = may ? 1 : 0;
            any = any || may;
        }
        if (!any) {
            return false;
        }
    }
    return true;
}

int Grid::leastTaken(std::size_t stages, std::size_t z, int taken) const {
    const Shape& shape = m_shapes[stages];
    return std::max(taken + shape.least[z], shape.leastBefore - shape.mostAfter[z]);
}

int Grid::mostTaken(std::size_t stages, std::size_t z, int taken) const {
    const Shape& shape = m_shapes[stages];
    return std::min(taken + shape.most[z], shape.mostBefore - shape.leastAfter[z]);
}

double Grid::mostLast_mm() const {
    double most = 0;
    for (const std::size_t stages : m_stageCounts) {
        int taken = 0;
        for (std::size_t z = 0; z + 1 < stages; ++z) {
            taken += m_shapes[stages].least[z];
        }
        most = std::max(most, remainder(std::max(taken, m_shapes[stages].leastBefore)));
    }
    return most;
}

bool Grid::mayFollow(std::size_t first, std::size_t second) const {
    const StageSetting& a = m_settings[first];
    const StageSetting& b = m_settings[second];
    return !m_nonIncreasing
           || (b.radial <= a.radial && b.axialFeed_mm_min <= a.axialFeed_mm_min
               && b.continuousFeed_mm_min <= a.continuousFeed_mm_min);
}

/// Ways to divide the steps among all stages but the last.
long double Grid::splits(const Shape& shape) const {
    if (shape.least.size() == 1) {
        return 1;
    }
    std::vector<long double> ways(static_cast<std::size_t>(m_steps) + 1, 0.0L); // by steps taken
    ways[0] = 1;
    for (std::size_t z = 0; z + 1 < shape.least.size(); ++z) {
        std::vector<long double> sums(ways.size() + 1, 0.0L); // of the earlier ways
        std::partial_sum(ways.begin(), ways.end(), sums.begin() + 1);
        for (int taken = 0; taken <= m_steps; ++taken) {
            const auto to = static_cast<std::size_t>(std::max(taken - shape.least[z] + 1, 0));
            const auto from = static_cast<std::size_t>(std::max(taken - shape.most[z], 0));
            ways[static_cast<std::size_t>(taken)] = to > from ? sums[to] - sums[from] : 0;
        }
    }
    return std::accumulate(ways.begin() + std::max(shape.leastBefore, 0),
                           ways.begin() + shape.mostBefore + 1, 0.0L);
}

// From the last stage to the first: number of extensions of a setting of this stage.
std::int64_t Grid::size() const {
    constexpr long double beyond = 9.3e18L; // exceeds 63 bits: the exact number does not matter
    long double total = 0;
    for (const std::size_t stages : m_stageCounts) {
        if (total > beyond) {
            break;
        }
        const Shape& shape = m_shapes[stages];
        std::vector<long double> ways(m_settings.size(), 1);
        for (std::size_t z = stages; z-- > 0;) {
            for (std::size_t s = 0; s < m_settings.size(); ++s) {
                ways[s] = mayHave(stages, z, s) ? ways[s] : 0;
            }
            if (z > 0) {
                ways = overFollowers(ways, 0.0L, std::plus<>());
            }
        }
        total += splits(shape) * std::accumulate(ways.begin(), ways.end(), 0.0L);
    }
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    return total < 9e18L ? std::llround(total) : most;
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

// An allowed setting leaves one for the next stage, and the stock left by leastTaken() and
// mostTaken() can be divided, so that a begun cycle can always be completed.
void Grid::complete(GridCycle& cycle, std::size_t stages) const {
    while (cycle.size() < stages) {
        std::size_t setting = 0;
        while (!mayExtend(cycle, stages, setting)) {
            ++setting;
        }
        const int taken = stepsTaken(cycle);
        const bool last = cycle.size() + 1 == stages;
        cycle.push_back({setting, last ? 0 : leastTaken(stages, cycle.size(), taken) - taken});
    }
}

bool Grid::advance(GridCycle& cycle) const {
    const std::size_t stages = cycle.size();
    while (!cycle.empty()) {
        GridStage stage = cycle.back();
        cycle.pop_back();
        const std::size_t z = cycle.size();
        const int taken = stepsTaken(cycle);
        const bool last = z + 1 == stages;
        if (!last && taken + stage.steps < mostTaken(stages, z, taken)) {
            cycle.push_back({stage.setting, stage.steps + 1});
            complete(cycle, stages);
            return true;
        }
        for (++stage.setting; stage.setting < m_settings.size(); ++stage.setting) {
            if (mayExtend(cycle, stages, stage.setting)) {
                cycle.push_back({stage.setting, last ? 0 : leastTaken(stages, z, taken) - taken});
                complete(cycle, stages);
                return true;
            }
        }
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
    if (count == m_stageCounts.end()) {
        return false;
    }
    complete(cycle, *count);
    return true;
}

GridCycle Grid::uniform(std::size_t stages, std::size_t setting) const {
    GridCycle cycle;
    while (cycle.size() < stages) {
        const bool last = cycle.size() + 1 == stages;
        std::size_t own = setting;
        while (last && m_sparkOut > 0 && own < m_settings.size()
               && !mayExtend(cycle, stages, own)) {
            ++own; // the spark-outs follow the feeds
        }
        if (own == m_settings.size() || !mayExtend(cycle, stages, own)) {
            return {};
        }
        const int taken = stepsTaken(cycle);
        cycle.push_back({own, last ? 0 : leastTaken(stages, cycle.size(), taken) - taken});
    }
    return cycle;
}

bool Grid::contains(const GridCycle& cycle) const {
    if (std::find(m_stageCounts.begin(), m_stageCounts.end(), cycle.size())
        == m_stageCounts.end()) {
        return false;
    }
    GridCycle begun;
    for (const GridStage& stage : cycle) {
        const int taken = stepsTaken(begun), behind = taken + stage.steps;
        const std::size_t z = begun.size();
        if (stage.setting >= m_settings.size() || !mayExtend(begun, cycle.size(), stage.setting)
            || (z + 1 < cycle.size()
                && (behind < leastTaken(cycle.size(), z, taken)
                    || behind > mostTaken(cycle.size(), z, taken)))) {
            return false;
        }
        begun.push_back(stage);
    }
    return true;
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

std::optional<GridCycle> Grid::find(const Cycle& stated) const {
    const StageFeed* const axial = m_operation->axial();
    const StageFeed* const continuous = m_operation->continuous;
    GridCycle found;
    for (const Stage& stage : stated.stages) {
        const auto valueOf = [&stage](const StageFeed* feed) {
            return feed ? (stage.*feed->value).value_or(0) : 0;
        };
        const auto setting = std::ranges::find_if(m_settings, [&](const StageSetting& each) {
            return each.sparkOut == stage.sparkOutSteps().value_or(0)
                   && each.radial == (stage.feeds() ? valueOf(&m_operation->radial()) : 0)
                   && each.axialFeed_mm_min == valueOf(axial)
                   && each.continuousFeed_mm_min == valueOf(continuous);
        });
        const bool isLast = found.size() + 1 == stated.stages.size();
        found.push_back({static_cast<std::size_t>(setting - m_settings.begin()),
                         isLast ? 0 : static_cast<int>(std::lround(stage.stock_mm / m_step_mm))});
    }
    if (!contains(found)) {
        return std::nullopt;
    }
    const Cycle same = cycle(found);
    for (std::size_t z = 0; z < found.size(); ++z) {
        constexpr double rounding_mm = 1e-9;
        if (std::abs(same.stages[z].stock_mm - stated.stages[z].stock_mm) > rounding_mm) {
            return std::nullopt;
        }
    }
    return found;
}

Cycle Grid::cycle(const GridCycle& cycle) const {
    Cycle stated;
    int taken = 0;
    for (const GridStage& each : cycle) {
        const StageSetting& setting = m_settings[each.setting];
        Stage stage;
        if (const StageFeed* const axial = m_operation->axial()) {
            stage.*axial->value = setting.axialFeed_mm_min;
        }
        if (setting.sparkOut > 0) {
            stage.sparkOutFor(setting.sparkOut);
        } else {
            stage.*m_operation->radial().value = setting.radial;
        }
        if (setting.continuousFeed_mm_min > 0) {
            stage.*m_operation->continuous->value = setting.continuousFeed_mm_min;
        }
        const bool takesAll =
            stated.stages.size() + 1 == cycle.size() || remainder(taken + each.steps) <= 0;
        stage.stock_mm = takesAll ? remainder(taken) : asWritten(each.steps * m_step_mm);
        taken += each.steps;
        stated.stages.push_back(stage);
    }
    return stated;
}

} // namespace sparkout
