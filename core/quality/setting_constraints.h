// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

/// The machine's ranges, the gauge's commands and the overlap: what the settings of a cycle are
/// held against [MODEL-8].
namespace sparkout {

/// Of the range of this kind.
void evaluateRange(ConstraintKind kind, const Judged& of, ConstraintResults& found);
void evaluateGaugeCommands(ConstraintKind kind, const Judged& of, ConstraintResults& found);
void evaluateOverlap(ConstraintKind kind, const Judged& of, ConstraintResults& found);

} // namespace sparkout
