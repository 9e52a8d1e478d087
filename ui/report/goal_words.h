// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal.h"
#include "core/lesson/goal_check.h"
#include "core/lesson/lesson.h"
#include "core/project/project.h"
#include "ui/report/format/report.h"
#include "ui/report/paper_writer.h"

#include <QCoreApplication>
#include <QString>

#include <cstddef>
#include <vector>

namespace sparkout::report {

/// Converts the markup of a lesson's text into blocks: paragraphs with indices, formulas, list
/// items, tables.
class LessonMarkup {
public:
    /// Numbers formulas starting from `formulas`, if given.
    [[nodiscard]] static std::vector<Block> blocks(const QString& markup, int* formulas = nullptr);
    /// The whole text on one line.
    [[nodiscard]] static QString inOneLine(const QString& markup);
};

/// Goals, their questions and results, in the current language.
class GoalWords {
    Q_DECLARE_TR_FUNCTIONS(GoalWords)
public:
    /// "Actual feed, НЗ, double stroke 20, E3"
    [[nodiscard]] static QString quantity(const sparkout::Figure& figure, const Project& project);
    [[nodiscard]] static QString unit(const sparkout::Figure& figure); ///< never empty: a dash
    /// With the unit after a comma, if it has one.
    [[nodiscard]] static QString withUnit(const QString& quantity, const sparkout::Figure& figure);
    [[nodiscard]] static QString number(const sparkout::Figure& figure, double value);
    /// A value with its unit, for a sentence.
    [[nodiscard]] static QString amount(const sparkout::Figure& figure, double value);
    [[nodiscard]] static QString place(const Project& project, std::size_t index);
    /// "НЗ > РЗ2 > РЗ1"
    [[nodiscard]] static QString order(const Project& project,
                                       const std::vector<std::size_t>& places);
    /// The abscissa of a curve: "Double stroke", "Stage", "Zone or section".
    [[nodiscard]] static QString along(const CurvePrediction& goal, const Project& project);
    /// A place on that axis: "20", "НЗ".
    [[nodiscard]] static QString alongAt(const CurvePrediction& goal, double at,
                                         const Project& project);
    [[nodiscard]] static QString finding(Finding finding);
    /// The question of a goal, a sentence; it does not reveal the answer.
    [[nodiscard]] static QString asked(const Goal& goal, const Project& project);
};

/// The answer to a step of the teacher's lesson: the engine's, or the right options.
class StepKey {
    Q_DECLARE_TR_FUNCTIONS(StepKey)
public:
    static void write(PaperWriter& paper, const Lesson& lesson, std::size_t step);
};

/// The curves of a step that asks for one, drawn in the window's thread.
class CurveFigure {
    Q_DECLARE_TR_FUNCTIONS(CurveFigure)
public:
    /// The predicted curve and the engine's.
    [[nodiscard]] static Figure compared(const CurvePrediction& goal, const Project& project,
                                         const GoalResult& result, const NumberRows& said);
    /// A grid to draw on. Its upper end is above all possible values, as far as the inputs
    /// determine them.
    [[nodiscard]] static Figure blank(const CurvePrediction& goal, const Project& project);
};

} // namespace sparkout::report
