// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/exercises.h"
#include "ui/report/format/report.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

/// The exercises of a project in words.
namespace sparkout::report {

struct Exercise : ExerciseRun {
    QString question;
    QString reason; ///< the change of each answer, and its reason
};

/// Makes the exercises of runExercises().
[[nodiscard]] std::vector<Exercise> makeExercises(
    const Outcome& outcome, const std::optional<RecordedStep>& step,
    const std::function<void()>& breathe = [] {});

[[nodiscard]] QString askedQuantity(Asked asked, Operation operation);
[[nodiscard]] QString askedName(Asked asked, Operation operation); ///< with its unit
[[nodiscard]] QString askedNumber(Asked asked, double value);
/// "Machining time rises".
[[nodiscard]] QString movedText(Asked asked, Operation operation, bool rises);

/// The exercises on paper: the questions, and the key.
[[nodiscard]] std::vector<Block> exerciseQuestions(const std::vector<Exercise>& exercises);
[[nodiscard]] std::vector<Block> exerciseAnswers(const std::vector<Exercise>& exercises,
                                                 Operation operation);

} // namespace sparkout::report
