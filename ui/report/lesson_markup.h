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
