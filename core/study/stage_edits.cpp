// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stage_edits.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sparkout {

double tidyStock(double stock_mm) {
    return std::round(stock_mm * 1e9) / 1e9;
}

Project withStageAfter(Project project, std::size_t stage) {
    auto& stages = project.cycle->stages;
    Stage added = stages[stage];
    const double micrometres = std::floor(added.stock_mm * 500 + 1e-9); // of half the stock
    added.stock_mm = micrometres > 0 ? micrometres / 1000 : tidyStock(added.stock_mm / 2);
    stages[stage].stock_mm = tidyStock(stages[stage].stock_mm - added.stock_mm);
    stages.insert(stages.begin() + static_cast<std::ptrdiff_t>(stage) + 1, added);
    return project;
}

Project withStock(Project project, std::size_t stage, double stock_mm, std::size_t other) {
    auto& stages = project.cycle->stages;
    const double both_mm = stages[stage].stock_mm + stages[other].stock_mm;
    stages[stage].stock_mm = stock_mm;
    stages[other].stock_mm = tidyStock(both_mm - stock_mm);
    return project;
}

int usualSparkOut(const Project& project) {
    constexpr int strokes = 2, leastRevolutions = 3;
    constexpr double time_s = 3;
    const double revolutions =
        std::round(time_s * project.machine->work_speed_rpm / units::secondsPerMinute);
    return project.operation->travels ? strokes
                                      : std::max(leastRevolutions, static_cast<int>(revolutions));
}

Project withSparkOutAfter(Project project, int steps) {
    auto& stages = project.cycle->stages;
    Stage added;
    if (const StageFeed* axial = project.operation->axial()) {
        added.*axial->value = stages.back().*axial->value;
    }
    added.sparkOutFor(steps);
    stages.push_back(added);
    return project;
}

Project withContinuousInfeed(Project project, bool stated) {
    for (Stage& stage : project.cycle->stages) {
        auto& feed = stage.continuous_feed_mm_min;
        feed = stated && stage.feeds() ? std::optional(feed.value_or(0)) : std::nullopt;
    }
    return project;
}

bool statesContinuousInfeed(const Project& project) {
    return std::ranges::any_of(project.cycle->stages, [](const Stage& stage) {
        return stage.continuous_feed_mm_min.has_value();
    });
}

} // namespace sparkout
