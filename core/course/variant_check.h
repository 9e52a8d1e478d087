// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/variant.h"

#include <optional>
#include <stop_token>

namespace sparkout {

/// Why levels that were drawn make no variant; in the order in which it is asked.
enum class VariantFault {
    alike,       ///< another variant has the same
    invalid,     ///< the project has errors, or its cycle does not end
    noFigure,    ///< the run has no figure that a step asks for
    solved,      ///< a step is solved as given
    otherFigure, ///< a figure is outside the bounds that the rules set
    noAnswer,    ///< no cycle of the grid holds what is asked
    notFree,     ///< the best answer changes inputs that are not free
    unattained,  ///< no value of a free input was found at which a figure is as asked
    tooQuick,    ///< the best answer is too quick beside that of the lesson
    tooSlow,     ///< or too slow
    otherMargin, ///< or its margin is too different
    count_
};
inline constexpr std::size_t variantFaults = static_cast<std::size_t>(VariantFault::count_);

/// What is known of levels: why they are refused, or their best answer.
struct CheckedVariant {
    std::optional<VariantFault> fault;
    std::optional<BestAnswer> best; ///< where a step asks for requirements or a time
};

/// Whether a step asks for what a search answers.
[[nodiscard]] bool needsSearch(const Lesson& lesson);

/// A set-up with another value of one free input, at which the figure is as a step asks that is met
/// by one; nothing: none was found.
[[nodiscard]] std::optional<Setup> attainingSetup(const Lesson& lesson, std::size_t step,
                                                  const std::stop_token& stop = {});

/// Decides on levels, all but whether they are alike; `reference` is the best answer of the lesson
/// as it stands. A stop refuses them as invalid.
[[nodiscard]] CheckedVariant checkVariant(const Lesson& lesson, const VariantLevels& levels,
                                          const std::optional<BestAnswer>& reference,
                                          const std::stop_token& stop = {});

} // namespace sparkout
