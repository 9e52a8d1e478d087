// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal_check.h"
#include "ui/session/lesson_run.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Lessons in the window's words.
class LessonText {
    Q_DECLARE_TR_FUNCTIONS(LessonText)
public:
    /// In the current language, or the only one.
    [[nodiscard]] static QString of(const Bilingual& text);
    /// As markup for use within other markup. A text that is invalid in a lesson, possible in an
    /// editor, shows its tags.
    [[nodiscard]] static QString tagged(const Bilingual& text);
    /// As standalone markup: formulas are set apart.
    [[nodiscard]] static QString markup(const Bilingual& text);

    /// "Actual feed: zone НЗ, stage 1, double stroke 20".
    [[nodiscard]] static QString figure(const Figure& figure, const Project& project);
    [[nodiscard]] static QString unit(const Figure& figure);
    [[nodiscard]] static QString value(double value, const Figure& figure); ///< with its unit
    [[nodiscard]] static QString place(const Project& project, std::size_t index);
    /// A place of comparison of a predicted curve: "5", "Stage 2", "НЗ".
    [[nodiscard]] static QString at(const CurvePrediction& goal, double at, const Project& project);
    /// Its abscissa: "Double stroke", "Stage", "Zone".
    [[nodiscard]] static QString along(const CurvePrediction& goal, const Project& project);

    /// The exact requirement: "Cycle time at most 2.500 min; every requirement is met." Empty if
    /// the task is complete.
    [[nodiscard]] static QString asked(const Goal& goal, const Project& project);
    /// The engine's result: "Not passed: cycle time 2.610 min, not met: roundness."
    [[nodiscard]] static QString found(const Goal& goal, const GoalResult& result);
    [[nodiscard]] static QString points(double points);
    [[nodiscard]] static QString mark(LessonRun::Mark mark);

private:
    [[nodiscard]] static QString numbers(const Goal& goal, const GoalResult& result);
};

} // namespace sparkout
