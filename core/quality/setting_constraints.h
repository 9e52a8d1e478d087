// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

/// Checks of a cycle's settings: the machine's ranges, the gauge's commands, the overlap and the
/// number of steps of a stage [MODEL-8].
namespace sparkout {

/// Checks the range of this kind.
void evaluateRange(ConstraintKind kind, const Judged& of, ConstraintResults& found);
void evaluateGaugeCommands(ConstraintKind kind, const Judged& of, ConstraintResults& found);
/// Checks the stages to which the requirement of this kind applies: see checkOverlaps().
void evaluateOverlap(ConstraintKind kind, const Judged& of, ConstraintResults& found);
/// Checks the stage with the fewest steps; no result where no stage counts.
void evaluateLeastSteps(ConstraintKind kind, const Judged& of, ConstraintResults& found);

} // namespace sparkout
