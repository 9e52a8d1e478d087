// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal.h"
#include "core/lesson/goal_check.h"
#include "core/project/project.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>

namespace sparkout::report {

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
