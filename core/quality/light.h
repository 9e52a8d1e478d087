// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <vector>

namespace sparkout {

/// The state of a requirement; close: met with a margin below a tenth of the tolerance or limit, or
/// undecided. A setting of the machine is met up to the end of its range.
enum class Light { holds, close, fails };

inline constexpr double closeMargin = 0.1;

/// Whether it is met by a small margin. A setting of the machine is met up to the end of its range.
[[nodiscard]] bool isClose(const ConstraintResult& constraint);

/// Whether it is undecided: an estimate met by its lower end and not by its upper end.
[[nodiscard]] bool isOpen(const ConstraintResult& constraint);

/// The order of importance: unmet before met, among the unmet first the overlap, on which others
/// depend where strips stay uncut; then close ones; then by the relative margin.
[[nodiscard]] bool isWorse(const ConstraintResult& first, const ConstraintResult& second);

/// The most important one: the worst unmet, otherwise the closest; null without any.
[[nodiscard]] const ConstraintResult*
worstRequirement(const std::vector<ConstraintResult>& constraints);

[[nodiscard]] Light lightOf(const ConstraintResult& constraint);

/// The verdict of a run: the worst of its requirements; a run that does not end by itself fails.
[[nodiscard]] Light verdictOf(RunStatus status, const std::vector<ConstraintResult>& constraints);

} // namespace sparkout
