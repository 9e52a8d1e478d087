// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

/// The machine's ranges, the gauge's commands, the overlap and the number of steps of a stage: what
/// the settings of a cycle are held against [MODEL-8].
namespace sparkout {

/// Of the range of this kind.
void evaluateRange(ConstraintKind kind, const Judged& of, ConstraintResults& found);
void evaluateGaugeCommands(ConstraintKind kind, const Judged& of, ConstraintResults& found);
/// Of the stages that are held against the requirement of this kind: see checkOverlaps().
void evaluateOverlap(ConstraintKind kind, const Judged& of, ConstraintResults& found);
/// Of the stage that made the fewest steps; none where no stage counts.
void evaluateLeastSteps(ConstraintKind kind, const Judged& of, ConstraintResults& found);

} // namespace sparkout
