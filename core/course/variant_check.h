// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/variant.h"

#include <optional>
#include <stop_token>

namespace sparkout {

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

} // namespace sparkout
