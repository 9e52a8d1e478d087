// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/variant_check.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// Variants of a lesson, drawn by a seed: the same ones on any machine, in any number of them the
/// same first ones.
///
/// Each is valid, its steps are not solved as given, and every step that asks for requirements or a
/// time is solved by the quickest cycle of the project's grid, which the search proves; one that
/// asks for a figure by a value of a free input that was found. The best answer is near to that of
/// the lesson as it stands in time and margin, and no two variants have the same inputs.
namespace sparkout {

struct MadeVariant {
    VariantLevels levels;
    std::optional<BestAnswer> best; ///< where a step asks for requirements or a time
};

/// Why a lesson has no variants at all.
enum class LessonFault {
    none,
    noGrid,      ///< what is asked is to be searched for, and the project has no grid
    noReference, ///< the lesson as it stands has no answer
};

struct MadeVariants {
    LessonFault fault = LessonFault::none;
    std::vector<MadeVariant> variants;
    std::optional<BestAnswer> reference; ///< of the lesson as it stands
    long long tries = 0;
    std::array<long long, variantFaults> refused{}; ///< tries, by the first reason
    bool isStopped = false;
};

/// Levels that were drawn, what was found of them, and how many variants there are by then.
struct VariantTry {
    VariantLevels levels;
    CheckedVariant found;
    std::size_t made = 0;
};

/// Draws until so many are found, or a limit of tries is reached; a lesson without variants gives
/// each the project as it stands. `note` is called after each try.
[[nodiscard]] MadeVariants makeVariants(const Lesson& lesson, std::size_t count, std::uint32_t seed,
                                        const std::stop_token& stop = {},
                                        const std::function<void(const VariantTry&)>& note = {});

/// How many tries are made at most for so many variants.
[[nodiscard]] constexpr long long mostTries(std::size_t count) {
    return 400 + 40 * static_cast<long long>(count);
}

} // namespace sparkout
