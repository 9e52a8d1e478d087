// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stage_edits.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace sparkout {

namespace {

/// Whether the column holds the feed along the work.
bool isAlong(const Project& project, const Field& column) {
    const StageFeed* axial = project.operation->axial();
    return axial && std::string_view(axial->key) == column.key;
}

constexpr std::string_view blanks(" \u00a0");

constexpr double sameStock_mm = 1e-9;

double sumFrom(const std::vector<Stage>& stages, std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < stages.size(); ++i) {
        sum += stages[i].stock_mm;
    }
    return sum;
}

} // namespace

std::optional<FeedForms> feedForms(const Project& project, const Field& column,
                                   double feed_mm_min) {
    const double work_rpm = project.machine->work_speed_rpm, width_mm = project.wheel->width_mm;
    if (std::string_view(column.unit) != "mm/min" || !(work_rpm > 0)) {
        return {};
    }
    FeedForms forms{feed_mm_min / work_rpm, {}};
    if (isAlong(project, column) && width_mm > 0) {
        forms.ofWidth = forms.perRevolution_mm / width_mm;
    }
    return forms;
}

std::optional<double> feedFromForm(const Project& project, const Field& column,
                                   std::string_view text) {
    if (!feedForms(project, column, 0)) {
        return {};
    }
    text = trimmed(text, blanks);
    double unit_mm = 0; // of a revolution
    for (const std::string_view suffix : {"mm/rev", "mm/r", "мм/об", "/rev", "/об"}) {
        if (unit_mm == 0 && text.ends_with(suffix)) {
            unit_mm = 1;
            text.remove_suffix(suffix.size());
        }
    }
    for (const std::string_view suffix : {"B", "b", "В", "в"}) { // Latin and Cyrillic
        if (unit_mm == 0 && isAlong(project, column) && text.ends_with(suffix)) {
            unit_mm = project.wheel->width_mm;
            text.remove_suffix(suffix.size());
        }
    }
    std::string digits(trimmed(text, blanks));
    std::ranges::replace(digits, ',', '.');
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool isNumber =
        error == std::errc() && end == digits.data() + digits.size() && std::isfinite(value);
    if (unit_mm == 0 || !isNumber) {
        return {};
    }
    const double feed_mm_min = value * unit_mm * project.machine->work_speed_rpm;
    const auto steps = machineSteps(project, std::string("/cycle/stages/0/") + column.key);
    return steps ? steps->nearest(feed_mm_min) : tidyStock(feed_mm_min);
}

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

bool stocksAddUp(const Project& project) {
    return std::abs(sumFrom(project.cycle->stages, 0) - project.part->stock_mm) <= sameStock_mm;
}

Project withFittedStocks(Project project) {
    auto& stages = project.cycle->stages;
    if (stages.empty() || stocksAddUp(project)) {
        return project;
    }
    const double stock_mm = project.part->stock_mm;
    auto rest = stages.begin(); // gets the remainder
    if (sumFrom(stages, 1) >= stock_mm) {
        const double scale = stock_mm / sumFrom(stages, 0);
        for (Stage& stage : stages) {
            stage.stock_mm = tidyStock(stage.stock_mm * scale);
        }
        rest = std::ranges::max_element(stages, {}, &Stage::stock_mm); // it absorbs the rounding
    }
    rest->stock_mm = tidyStock(rest->stock_mm + stock_mm - sumFrom(stages, 0));
    return project;
}

} // namespace sparkout
