// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search_edits.h"

#include "core/format/project_file.h"
#include "core/optimisation/variants.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr double levelsOfAFeed = 12, stepsOfStock = 15;
constexpr double beyondTheFastest = 1.5;

/// The nearest of 1, 2 and 5 times a power of ten.
double roundStep(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double digits = value / power;
    return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

/// `count` steps as the decimal it is.
double times(double step, double count) {
    return step < 1 ? count / std::round(1 / step) : count * step;
}

/// Levels of a feed up to half above the fastest of these, within the machine's range and up to
/// what a level may be; none where the machine's range begins beyond that.
Levels usualLevels(const std::vector<double>& feeds,
                   const std::optional<std::vector<double>>& range, double highest) {
    const bool limited = range && range->size() == 3;
    const double lower = limited ? (*range)[0] : 0;
    const double upper = limited ? std::min((*range)[1], highest) : highest;
    const double fastest = feeds.empty() ? 0 : std::min(*std::ranges::max_element(feeds), highest);
    if (!(fastest > 0) || lower > upper) {
        return {};
    }
    const double most = std::clamp(fastest * beyondTheFastest, lower, upper);
    double step = roundStep(fastest * beyondTheFastest / levelsOfAFeed);
    double least = step;
    if (limited) {
        step = std::max(step, (*range)[2]);
        least = std::max(step, lower);
    }
    const double from = times(step, std::ceil(least / step - 1e-9));
    const double to = times(step, std::floor(most / step + 1e-9));
    return from < to ? Levels(SteppedLevels{from, to, times(step, 1)})
                     : Levels(std::vector<double>{std::clamp(fastest, lower, upper)});
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
    for (const StageFeed& feed : project.operation->feeds) {
        search.*feed.levels = usualLevels(feedsOf(*project.cycle, feed.value), limits.*feed.range,
                                          tableOf<Optimisation>().find(feed.key)->hard.high);
    }
    project.optimisation = std::move(search);
    return project;
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
        if (project.optimisation) { // what is searched need not be as it was
            const Optimisation& asked = *project.optimisation;
            const auto free = [](const Levels& levels, double own) {
                return levels == Levels() ? own : 0;
            };
            setMachine(project, {free(asked.work_speed_rpm, project.machine->work_speed_rpm),
                                 free(asked.dwell_entry_s, project.machine->dwell_entry_s),
                                 free(asked.dwell_exit_s, project.machine->dwell_exit_s)});
        }
        if (!project.optimisation
            || project.optimisation->scenarios == OptimisationScenarios::nominal) {
            project.batch.reset();
        }
        return project;
    };
    return sameProject(searched(a), searched(b));
}

} // namespace sparkout
