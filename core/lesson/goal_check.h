// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/answer.h"
#include "core/lesson/figure_value.h"
#include "core/lesson/lesson.h"
#include "core/quality/requirement.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Goals held against what a student has set and answered, by the engine. The words are
/// words/lesson_words.h.
namespace sparkout {

enum class Finding {
    passed,
    failed,
    notAnswered,  ///< nothing was handed in, or not what the goal asks for
    forTeacher,   ///< words, which no engine reads
    forbidden,    ///< inputs were changed that are not free
    refused,      ///< the set-up has errors, and nothing was run
    doesNotEnd,   ///< the cycle does not end by itself
    noSuchFigure, ///< the run has no such figure, or strips stay uncut
};
inline constexpr int findings = static_cast<int>(Finding::noSuchFigure) + 1;

/// One place of a predicted curve.
struct ComparedPoint {
    double at = 0;
    std::optional<double> said; ///< nothing: the curve does not reach it
    double value = 0;           ///< the engine's
    bool isWithin = false;
};

/// What came of a goal, in numbers. `value` is the engine's and `asked` what it was held against:
/// of a time the greatest one that passes, of a figure the value asked for, of a prediction what
/// was said; all in the unit of the goal (min, %, or that of the figure).
struct GoalResult {
    GoalKind kind = GoalKind::text;
    Finding finding = Finding::notAnswered;
    std::optional<double> value, asked;
    double tolerance = 0;                ///< either way
    std::vector<ConstraintKind> failing; ///< requirements that do not hold
    /// Of a cycle that holds for the part that was run: the share of stocks for which it does not.
    std::optional<double> failingStocks_percent;
    std::vector<ComparedPoint> curve; ///< of a predicted curve
    std::vector<std::size_t> order;   ///< places by the engine, the largest first
    std::optional<double> time_min;   ///< of the cycle that was run, when it ended by itself
    RunStatus status = RunStatus::completed;
    std::vector<std::string> forbidden; ///< paths of inputs changed that are not free
    Issues issues;                      ///< of a set-up that cannot be run

    [[nodiscard]] bool passed() const { return finding == Finding::passed; }
};

/// Holds a goal against a run and an answer. A goal of words or a choice asks for no run.
[[nodiscard]] GoalResult checkGoal(const Goal& goal, const FigureSource& run, const Answer& answer);

/// Whether a goal asks for a run, and for one that is recorded.
[[nodiscard]] bool needsRun(const Goal& goal);
[[nodiscard]] bool needsRecordedRun(const Goal& goal);

/// Checks what was handed in for a step: reads the set-up, holds it against what was free, runs its
/// cycle and holds the goal against it. What the answer says of results is never asked.
[[nodiscard]] GoalResult checkStep(const Lesson& lesson, std::size_t step, const Answer& answer,
                                   const std::stop_token& stop = {});

} // namespace sparkout
