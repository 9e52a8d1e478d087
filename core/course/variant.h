// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

/// A variant of a lesson: the drawn level of each varied input, from 0.
namespace sparkout {

using VariantLevels = std::vector<std::size_t>;

/// The quickest cycle of a project's grid that meets every requirement: proved by the search.
struct BestAnswer {
    double time_min = 0;
    double margin_percent = 0; ///< least relative margin of the requirements
    Project project;           ///< project with this cycle
};

/// The best answer for the varied surface; empty if no cycle of the grid is fit, there is no grid,
/// or it was stopped.
[[nodiscard]] std::optional<BestAnswer> bestAnswer(const Project& project,
                                                   const std::stop_token& stop = {});

/// The number of levels of each varied input; empty if a lesson has no variants.
[[nodiscard]] VariantLevels levelCounts(const Lesson& lesson);

/// Whether these are levels of the lesson.
[[nodiscard]] bool areLevels(const Lesson& lesson, const VariantLevels& levels);

/// Whether a step asks for a time that follows from the best.
[[nodiscard]] bool asksForBest(const Lesson& lesson);

[[nodiscard]] std::size_t variedSurface(const Lesson& lesson);

/// The lesson with the inputs of a variant. Times that depend on the best are set if it is given:
/// rounded up to a thousandth of a minute.
[[nodiscard]] Lesson withVariant(Lesson lesson, const VariantLevels& levels,
                                 const std::optional<double>& best_min);

/// The original lesson, without a variant, with the times that depend on the best set.
[[nodiscard]] Lesson withBestTimes(Lesson lesson, const std::stop_token& stop = {});

/// The greatest time that passes, from the best.
[[nodiscard]] double timeAllowed_min(double best_min, double within_percent);

} // namespace sparkout
