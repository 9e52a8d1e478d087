// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

/// A variant of a lesson: for each input that is varied the level drawn, from 0.
namespace sparkout {

using VariantLevels = std::vector<std::size_t>;

/// The quickest cycle of a project's grid that meets every requirement: proved by the search.
struct BestAnswer {
    double time_min = 0;
    double margin_percent = 0; ///< least relative margin of a requirement
    Project project;           ///< with this cycle
};

/// Of the surface that is varied; nothing: no cycle of the grid holds, there is no grid, or it was
/// stopped.
[[nodiscard]] std::optional<BestAnswer> bestAnswer(const Project& project,
                                                   const std::stop_token& stop = {});

/// How many levels each varied input has; none where a lesson has no variants.
[[nodiscard]] VariantLevels levelCounts(const Lesson& lesson);

/// Whether these are levels of the lesson.
[[nodiscard]] bool areLevels(const Lesson& lesson, const VariantLevels& levels);

/// Whether a step asks for a time that follows from the best.
[[nodiscard]] bool asksForBest(const Lesson& lesson);

/// The index of the surface that is varied.
[[nodiscard]] std::size_t variedSurface(const Lesson& lesson);

/// The lesson with the inputs of a variant in place. Times that follow from the best are put in
/// where it is given: rounded up to a thousandth of a minute.
[[nodiscard]] Lesson withVariant(Lesson lesson, const VariantLevels& levels,
                                 const std::optional<double>& best_min);

/// The lesson as it stands, without a variant: times that follow from the best are put in.
[[nodiscard]] Lesson withBestTimes(Lesson lesson, const std::stop_token& stop = {});

/// The greatest time that passes, from the best.
[[nodiscard]] double timeAllowed_min(double best_min, double within_percent);

} // namespace sparkout
