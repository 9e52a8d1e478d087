// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search_edits.h"

#include "core/format/project_file.h"
#include "core/optimisation/levels.h"
#include "core/optimisation/variants.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr double stepsOfStock = 15;

/// The nearest of 1, 2 and 5 times a power of ten.
double roundStep(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double digits = value / power;
    return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

/// The preferred numbers R5 between two of them, inclusive [ISO 3].
std::vector<double> preferred(double from, double to) {
    constexpr std::array series{1.0, 1.6, 2.5, 4.0, 6.3};
    std::vector<double> values{from};
    for (int decade = static_cast<int>(std::floor(std::log10(from))); std::pow(10, decade) < to;
         ++decade) {
        for (const double each : series) {
            const double value =
                decade < 0 ? each / std::round(std::pow(10, -decade)) : each * std::pow(10, decade);
            if (value > from && value < to) {
                values.push_back(value);
            }
        }
    }
    values.push_back(to);
    return values;
}

/// Levels of a feed: preferred numbers over the machine's range, in its steps; without a range from
/// a fortieth of the fastest of these to twice that. Empty if the range has no valid level.
Levels usualLevels(const std::vector<double>& feeds,
                   const std::optional<std::vector<double>>& range, double highest) {
    constexpr double below = 20, above = 2;
    const double fastest = feeds.empty() ? 0 : *std::ranges::max_element(feeds);
    std::vector<double> levels;
    if (range && range->size() == 3) {
        const double low = (*range)[0], high = std::min((*range)[1], highest), step = (*range)[2];
        const double least = low > 0 ? low : step;
        if (!(least > 0) || least > high) {
            return {};
        }
        for (const double each : preferred(least, high)) {
            const double steps = std::round((each - low) / step);
            const double level = each >= high ? high : asWritten(low + steps * step);
            if (level > 0 && level <= high && (levels.empty() || level > levels.back())) {
                levels.push_back(level);
            }
        }
    } else if (fastest > 0 && fastest <= highest) {
        levels =
            preferred(roundStep(fastest / below), std::min(roundStep(fastest * above), highest));
    }
    return levels.empty() ? Levels() : Levels(levels);
}

template <class Member>
std::vector<double> feedsOf(const Cycle& cycle, Member member) {
    std::vector<double> feeds;
    for (const Stage& stage : cycle.stages) {
        if (stage.*member && *(stage.*member) > 0) {
            feeds.push_back(*(stage.*member));
        }
    }
    return feeds;
}

} // namespace

Project withUsualSearch(Project project) {
    const MachineLimits& limits = project.machine->limits;
    Optimisation search;
    const auto stages = std::clamp<std::size_t>(project.cycle->stages.size(), 2, 3);
    search.stages.clear();
    for (std::size_t count = 1; count <= stages; ++count) {
        search.stages.push_back(static_cast<double>(count));
    }
    search.stock_step_mm = std::clamp(roundStep(project.part->stock_mm / stepsOfStock), 1e-4, 5.0);
    search.non_increasing = true;
    search.adaptive = true;
    for (const StageFeed& feed : project.operation->feeds) {
        search.*feed.levels = usualLevels(feedsOf(*project.cycle, feed.value), limits.*feed.range,
                                          tableOf<Optimisation>().find(feed.key)->hard.high);
    }
    project.optimisation = std::move(search);
    return project;
}

Project withPracticalLimits(Project project) {
    constexpr double usualLeastOverlap = 1.05, usualLeastOverlapLast = 2;
    project.least_overlap = project.least_overlap.value_or(usualLeastOverlap);
    project.least_overlap_last = project.least_overlap_last.value_or(usualLeastOverlapLast);
    project.least_steps = project.least_steps.value_or(project.operation->usualLeastSteps);
    return project;
}

Project withOfferedSearch(Project project) {
    return withPracticalLimits(withUsualSearch(std::move(project)));
}

Project withSearchFor(Project project) {
    if (!project.optimisation) {
        return project;
    }
    const Project withUsual = withUsualSearch(project);
    const Optimisation& usual = *withUsual.optimisation;
    Optimisation& asked = *project.optimisation;
    for (const StageFeed& feed : project.operation->feeds) {
        if (asked.*feed.levels == Levels()) {
            asked.*feed.levels = usual.*feed.levels;
        }
    }
    return project;
}

bool sameSearch(const Project& a, const Project& b) {
    const auto searched = [](Project project) {
        *project.cycle = {};
        project.title.clear();
        project.author.clear();
        project.notes.clear();
        project.measured.reset();
        project.runs.clear();
        project.sweep.reset();
        if (project.optimisation) { // the search need not stay unchanged
            const Optimisation& asked = *project.optimisation;
            const auto free = [](const Levels& levels, double own) {
                return levels == Levels() ? own : 0;
            };
            setMachine(project, {free(asked.work_speed_rpm, project.machine->work_speed_rpm),
                                 free(asked.dwell_entry_s, project.machine->dwell_entry_s),
                                 free(asked.dwell_exit_s, project.machine->dwell_exit_s)});
        }
        if (!project.optimisation || !areOfBatch(project.optimisation->scenarios)) {
            project.batch.reset();
        }
        return project;
    };
    return sameProject(searched(a), searched(b));
}

} // namespace sparkout
