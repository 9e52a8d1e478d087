// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// Variants of a lesson, drawn by a seed: the same on any machine, and a longer series begins like
/// a shorter one.
///
/// Each is valid, its steps are not solved as given, and every step that asks for requirements or a
/// time is solved by the quickest cycle of the project's grid, which the search proves; a step that
/// asks for a figure, by a value of a free input that was found. The best answer is near that of
/// the original lesson in time and margin, and no two variants have the same inputs.

namespace sparkout {

/// A variant of a lesson: the drawn level of each varied input, from 0.
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

/// The reasons for rejecting drawn levels, in the order of the checks.
enum class VariantFault {
    alike,       ///< another variant has the same inputs
    invalid,     ///< the project has errors, or its cycle does not end
    noFigure,    ///< the run has no figure required by a step
    solved,      ///< a step is solved without changes
    otherFigure, ///< a figure is outside the bounds that the rules set
    noAnswer,    ///< no cycle of the grid meets the requirements
    notFree,     ///< the best answer changes inputs that are not free
    unattained,  ///< no value of a free input was found that gives a required figure
    tooQuick,    ///< the best answer is too quick compared with that of the lesson
    tooSlow,     ///< the best answer is too slow
    otherMargin, ///< its margin differs too much
    count_
};
inline constexpr std::size_t variantFaults = static_cast<std::size_t>(VariantFault::count_);

/// The result for drawn levels: why they are rejected, or their best answer.
struct CheckedVariant {
    std::optional<VariantFault> fault;
    std::optional<BestAnswer> best; ///< for a step that asks for requirements or a time
};

[[nodiscard]] bool needsSearch(const Lesson& lesson);

/// A set-up with a value of one free input that gives the required figure of a step; empty if none
/// was found.
[[nodiscard]] std::optional<Setup> attainingSetup(const Lesson& lesson, std::size_t step,
                                                  const std::stop_token& stop = {});

/// Checks levels, except for duplicates; `reference` is the best answer of the original lesson. A
/// stop rejects them as invalid.
[[nodiscard]] CheckedVariant checkVariant(const Lesson& lesson, const VariantLevels& levels,
                                          const std::optional<BestAnswer>& reference,
                                          const std::stop_token& stop = {});

struct MadeVariant {
    VariantLevels levels;
    std::optional<BestAnswer> best; ///< for a step that asks for requirements or a time
};

/// Why a lesson has no variants at all.
enum class LessonFault {
    none,
    noGrid,      ///< a search is needed and the project has no grid
    noReference, ///< the original lesson has no answer
};

struct MadeVariants {
    LessonFault fault = LessonFault::none;
    std::vector<MadeVariant> variants;
    std::optional<BestAnswer> reference; ///< best answer of the original lesson
    long long tries = 0;
    std::array<long long, variantFaults> refused{}; ///< tries, by the first reason
    bool isStopped = false;
};

/// The levels of a try, its result, and the number of variants found so far.
struct VariantTry {
    VariantLevels levels;
    CheckedVariant found;
    std::size_t made = 0;
};

/// Draws until `count` variants are found, or a limit of tries is reached; without rules every
/// variant is the original project. `note` is called after each try.
[[nodiscard]] MadeVariants makeVariants(const Lesson& lesson, std::size_t count, std::uint32_t seed,
                                        const std::stop_token& stop = {},
                                        const std::function<void(const VariantTry&)>& note = {});

/// Greatest number of tries for a number of variants.
[[nodiscard]] constexpr long long mostTries(std::size_t count) {
    return 400 + 40 * static_cast<long long>(count);
}

} // namespace sparkout
