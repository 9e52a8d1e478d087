// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/variant.h"

#include "core/optimisation/optimise.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

std::optional<BestAnswer> bestAnswer(const Project& project, const std::stop_token& stop) {
    if (!project.optimisation || hasErrors(validate(project))
        || Variants(project, stop).fault() != GridFault::none) {
        return std::nullopt;
    }
    SearchOptions options;
    options.stop = stop;
    const SearchSummary summary = optimise(project, options);
    if (summary.status != SearchStatus::proved || !summary.best) {
        return std::nullopt;
    }
    constexpr double percent = 100;
    return BestAnswer{summary.best->time_s / units::secondsPerMinute,
                      summary.best->leastRelativeMargin * percent, withBest(project, summary)};
}

VariantLevels levelCounts(const Lesson& lesson) {
    VariantLevels counts;
    if (lesson.variants) {
        for (const VariedInput& input : lesson.variants->inputs) {
            counts.push_back(static_cast<std::size_t>(input.levels()));
        }
    }
    return counts;
}

bool areLevels(const Lesson& lesson, const VariantLevels& levels) {
    const VariantLevels counts = levelCounts(lesson);
    return std::equal(levels.begin(), levels.end(), counts.begin(), counts.end(),
                      [](std::size_t level, std::size_t count) { return level < count; });
}

bool asksForBest(const Lesson& lesson) {
    return std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& step) {
        return step.goal.time && !step.goal.time->below_min;
    });
}

std::size_t variedSurface(const Lesson& lesson) {
    return lesson.variants ? static_cast<std::size_t>(lesson.variants->surface) - 1 : 0;
}

Lesson withBestTimes(Lesson lesson, const std::stop_token& stop) {
    if (!asksForBest(lesson)) {
        return lesson;
    }
    const auto best = bestAnswer(lesson.base.surfaces[variedSurface(lesson)].project, stop);
    return withVariant(std::move(lesson), {}, best ? std::optional(best->time_min) : std::nullopt);
}

double timeAllowed_min(double best_min, double within_percent) {
    constexpr double percent = 100, perMinute = 1000, lastBit = 1e-9;
    return std::ceil(best_min * (1 + within_percent / percent) * perMinute - lastBit) / perMinute;
}

Lesson withVariant(Lesson lesson, const VariantLevels& levels,
                   const std::optional<double>& best_min) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
        for (const InputValue& value : lesson.variants->inputs[i].valuesAt(levels[i])) {
            (void)putInput(lesson.base, variedSurface(lesson), value);
        }
    }
    for (LessonStep& step : lesson.steps) {
        if (best_min && step.goal.time && !step.goal.time->below_min) {
            step.goal.time->below_min =
                timeAllowed_min(*best_min, *step.goal.time->within_percent_of_best);
        }
    }
    return lesson;
}

} // namespace sparkout
