// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/handout_step.h"
#include "ui/report/handout/step_formulas.h"

#include <QCoreApplication>

namespace sparkout::report {

/// The step that the hand-out works out: where it is, its formulas and its limits.
class WorkedStep {
    Q_DECLARE_TR_FUNCTIONS(WorkedStep)
public:
    static Facts facts(const Outcome& outcome, const HandoutStep& step);
    /// Force law, balance and limits of the step.
    static StepBlocks formulas(const Outcome& outcome, const HandoutStep& step,
                               Citations& citations);
    static Table limits(const Outcome& outcome, const HandoutStep& step);
};

} // namespace sparkout::report
