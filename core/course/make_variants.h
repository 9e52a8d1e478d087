// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/variant_check.h"

#include <array>
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
