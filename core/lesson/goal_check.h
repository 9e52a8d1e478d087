// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/figure_value.h"
#include "core/lesson/goal.h"
#include "core/lesson/lesson.h"
#include "core/quality/requirement.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Checks of a student's settings and answers by the engine. The texts are in words/goal_words.h.
namespace sparkout {

enum class Finding {
    passed,
    failed,
    notAnswered,  ///< nothing was handed in, or not what the goal requires
    forTeacher,   ///< words, which the teacher reads
    forbidden,    ///< locked inputs were changed
    refused,      ///< the set-up has errors and was not run
    doesNotEnd,   ///< the cycle does not end by itself
    noSuchFigure, ///< the run does not have this figure, or strips stay uncut
};
inline constexpr int findings = static_cast<int>(Finding::noSuchFigure) + 1;

/// A place at which a predicted curve is compared.
struct ComparedPoint {
    double at = 0;
    std::optional<double> said; ///< empty: the curve does not reach it
    double value = 0;           ///< the engine's
    bool isWithin = false;
};

/// The numerical result of a goal. `value` is the engine's, `asked` its counterpart: the greatest
/// time that passes, the required value of a figure, or the prediction; all in the unit of the goal
/// (min, %, or that of the figure).
struct GoalResult {
    GoalKind kind = GoalKind::text;
    Finding finding = Finding::notAnswered;
    std::optional<double> value, asked;
    double tolerance = 0;                ///< ±
    std::vector<ConstraintKind> failing; ///< requirements that are not met
    /// For a cycle that is fit for the part that was run: the share of stocks for which it is not.
    std::optional<double> failingStocks_percent;
    std::vector<ComparedPoint> curve; ///< for a predicted curve
    std::vector<std::size_t> order;   ///< places as computed, the largest first
    std::optional<double> time_min;   ///< time of the cycle, if it ended by itself
    RunStatus status = RunStatus::completed;
    std::vector<std::string> forbidden; ///< paths of inputs changed that are not free
    Issues issues;                      ///< faults of a set-up that cannot be run

    [[nodiscard]] bool passed() const { return finding == Finding::passed; }
};

/// Checks a goal against a run and an answer. A goal of words or a choice needs no run.
[[nodiscard]] GoalResult checkGoal(const Goal& goal, const FigureSource& run, const Answer& answer);

/// Whether a goal asks for a run, and for one that is recorded.
[[nodiscard]] bool needsRun(const Goal& goal);
[[nodiscard]] bool needsRecordedRun(const Goal& goal);

/// Checks a submission for a step: reads the set-up, checks it against the free inputs, runs its
/// cycle and checks the goal. Results stated in the answer are ignored.
[[nodiscard]] GoalResult checkStep(const Lesson& lesson, std::size_t step, const Answer& answer,
                                   const std::stop_token& stop = {});

} // namespace sparkout
