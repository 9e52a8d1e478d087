// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search_levels.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/search/grid.h"
#include "core/search/variants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr double lastBits = 1e-9; ///< relative
constexpr int mostRounds = 10;

bool isSame(double a, double b) {
    return std::abs(a - b) <= lastBits * std::abs(b);
}

std::vector<double> sortedLevels(const Optimisation& search, const StageFeed& feed) {
    std::vector<double> values = levelValues(search.*feed.levels);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end(), isSame), values.end());
    return values;
}

/// The allowed range of a feed's levels.
struct LevelRange {
    double low = 0, high = 0;
    double step = 0; ///< 0: three significant digits
    bool isOfMachine = false;

    LevelRange(const Project& project, const StageFeed& feed) {
        const auto& range = project.machine->limits.*feed.range;
        const Range hard = tableOf<Optimisation>().find(feed.key)->hard;
        low = hard.low;
        high = hard.high;
        if ((isOfMachine = range && range->size() == 3)) {
            low = std::max(low, (*range)[0]);
            high = std::min(high, (*range)[1]);
            step = (*range)[2];
        }
    }

    /// The nearest that can be set.
    [[nodiscard]] double rounded(double value) const {
        double by = step;
        if (!(by > 0)) {
            constexpr int digits = 2; // after the first
            by = std::pow(10.0, std::floor(std::log10(value)) - digits);
        }
        const double nearest =
            isOfMachine ? low + std::round((value - low) / by) * by : std::round(value / by) * by;
        return asWritten(std::clamp(nearest, low, high));
    }
};

/// The limit of the range and the stage's own bounds.
double limitOf(const Optimisation& search, const StageFeed& feed, std::size_t stage,
               const LevelRange& range, bool isMost) {
    const double own = isMost ? range.high : range.low;
    const NumberRows& rows = search.*feed.byStage;
    if (!rows || stage >= rows->size()) {
        return own;
    }
    const std::vector<double>& ends = (*rows)[stage];
    return isMost ? std::min(own, ends[1]) : std::max(own, ends[0]);
}

/// Adds three levels beyond the last of them, by the ratio of the last two.
void addBeyond(std::vector<double>& levels, const LevelRange& range, bool isMost) {
    constexpr int added = 3;
    constexpr double leastRatio = 1.1;
    const std::size_t n = levels.size();
    const double ratio = isMost ? levels[n - 1] / levels[n - 2] : levels[1] / levels[0];
    double level = isMost ? levels.back() : levels.front();
    for (int i = 0; i < added; ++i) {
        level = isMost ? level * std::max(ratio, leastRatio) : level / std::max(ratio, leastRatio);
        levels.push_back(range.rounded(std::clamp(level, range.low, range.high)));
    }
}

/// Adds a level between each of these and its neighbours, if they are far enough apart.
void addBetween(std::vector<double>& levels, const LevelRange& range,
                const std::vector<double>& used) {
    constexpr double nearest = 1.05;
    std::vector<double> more;
    for (const double each : used) {
        const auto at = std::ranges::find_if(levels, [each](double l) { return isSame(l, each); });
        if (at == levels.end()) {
            continue;
        }
        if (at != levels.begin() && *at / *(at - 1) > nearest) {
            more.push_back(range.rounded(std::sqrt(*at * *(at - 1))));
        }
        if (at + 1 != levels.end() && *(at + 1) / *at > nearest) {
            more.push_back(range.rounded(std::sqrt(*at * *(at + 1))));
        }
    }
    levels.insert(levels.end(), more.begin(), more.end());
}

} // namespace

std::vector<LevelEdge> edgesReached(const Project& searched, const Cycle& cycle) {
    const Optimisation& search = *searched.optimisation;
    std::vector<LevelEdge> edges;
    for (const StageFeed* each : searched.operation->searchedFeeds()) {
        const StageFeed& feed = *each;
        const std::vector<double> levels = sortedLevels(search, feed);
        if (levels.size() < 2) {
            continue;
        }
        const LevelRange range(searched, feed);
        for (std::size_t z = 0; z < cycle.stages.size(); ++z) {
            const double value = (cycle.stages[z].*feed.value).value_or(0);
            if (!(value > 0) || !cycle.stages[z].feeds()) {
                continue;
            }
            for (const bool isMost : {false, true}) {
                const double level = isMost ? levels.back() : levels.front();
                if (isSame(value, level)) {
                    const double limit = limitOf(search, feed, z, range, isMost);
                    const bool isLimit =
                        isMost ? limit <= level * (1 + lastBits) : limit >= level * (1 - lastBits);
                    const double end = isMost ? range.high : range.low;
                    edges.push_back({&feed, z, level, isMost,
                                     limit > 0 ? std::optional(limit) : std::nullopt, isLimit,
                                     limit != end,
                                     range.isOfMachine ? std::optional(end) : std::nullopt});
                }
            }
        }
    }
    return edges;
}

std::vector<SettingEdge> settingEdgesReached(const Project& searched, const Cycle& cycle,
                                             const MachineSettings& machine) {
    const Optimisation& search = *searched.optimisation;
    std::vector<SettingEdge> edges;
    using Farthest = double (*)(const Project&, double level, double end);
    const Farthest anyValue = [](const Project&, double, double end) { return end; };
    const auto add = [&](const char* key, std::vector<double> levels, double value,
                         const std::optional<std::vector<double>>& range, Farthest farthest) {
        std::ranges::sort(levels);
        if (levels.size() < 2 || isSame(levels.front(), levels.back())) {
            return;
        }
        const Range hard = tableOf<Optimisation>().find(key)->hard;
        const bool isOfMachine = range && range->size() == 3;
        for (const bool isMost : {false, true}) {
            const double level = isMost ? levels.back() : levels.front();
            if (value != level && !isSame(value, level)) {
                continue;
            }
            const double end = isMost ? isOfMachine ? std::min((*range)[1], hard.high) : hard.high
                               : isOfMachine ? std::max((*range)[0], hard.low)
                                             : hard.low;
            const double limit = farthest(searched, level, end);
            const bool isLimit =
                isMost ? limit <= level * (1 + lastBits) : limit >= level * (1 - lastBits);
            edges.push_back({key, level, isMost, limit, isLimit});
        }
    };
    add("work_speed_rpm", searchedSpeeds(searched).allowed, machine.work_speed_rpm,
        searched.machine->limits.work_speed_rpm, &farthestSpeed_rpm);
    if (searched.operation->travels) {
        add("dwell_entry_s", levelValues(search.dwell_entry_s), machine.dwell_entry_s, std::nullopt,
            anyValue);
        add("dwell_exit_s", levelValues(search.dwell_exit_s), machine.dwell_exit_s, std::nullopt,
            anyValue);
    }
    add(Stage::sparkOutKey, levelValues(search.unfed_steps),
        cycle.stages.back().sparkOutSteps().value_or(0), std::nullopt, anyValue);
    return edges;
}

SearchLevels::SearchLevels(Project project) : m_searched(std::move(project)) {}

bool SearchLevels::beginNextRound(const Cycle& best, const FeasibleCycle& found) {
    if (!m_searched.optimisation->adaptive || m_round == mostRounds) {
        return false;
    }
    constexpr double leastSaving = 0.005;
    const bool saves =
        !m_time_s
        || (marginWithinOf(m_searched) ? found.leastRelativeMargin > *m_margin + leastSaving
                                       : found.time_s < *m_time_s * (1 - leastSaving));
    m_time_s = found.time_s;
    m_margin = found.leastRelativeMargin;
    const std::vector<LevelEdge> edges = edgesReached(m_searched, best);
    Project next = m_searched;
    bool more = false;
    for (const StageFeed* each : m_searched.operation->searchedFeeds()) {
        const StageFeed& feed = *each;
        std::vector<double> levels = sortedLevels(*m_searched.optimisation, feed);
        const std::size_t before = levels.size();
        if (before < 2) {
            continue; // fixed
        }
        const LevelRange range(m_searched, feed);
        std::vector<double> used;
        for (const Stage& stage : best.stages) {
            if ((stage.*feed.value).value_or(0) > 0) {
                used.push_back(*(stage.*feed.value));
            }
        }
        if (saves) {
            addBetween(levels, range, used);
        }
        for (const bool isMost : {false, true}) {
            if (std::ranges::any_of(edges, [&](const LevelEdge& edge) {
                    return edge.feed == &feed && edge.isMost == isMost && !edge.isLimit;
                })) {
                std::ranges::sort(levels);
                addBeyond(levels, range, isMost);
            }
        }
        (*next.optimisation).*feed.levels = levels;
        levels = sortedLevels(*next.optimisation, feed);
        (*next.optimisation).*feed.levels = levels;
        more |= levels.size() > before;
    }
    if (!more || Variants(next).fault() != GridFault::none) {
        return false;
    }
    m_searched = std::move(next);
    ++m_round;
    return true;
}

} // namespace sparkout
