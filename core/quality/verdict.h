// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <optional>
#include <vector>

namespace sparkout {

/// Faults of the inputs that only a run reveals; warnings, like those of validate(): a spark-out of
/// a fixed number whose stage has a stock that the deflection did not release, so that the gauge
/// ends beyond the drawing's limit; a stage whose stock was removed before it began [MODEL-7]; a
/// dwell changed by rounding to whole revolutions [MODEL-5]; a factor of Ra far from that of the
/// measured Ra [MODEL-8].
[[nodiscard]] Issues remarksOn(const SimulationResult& result);

/// How a requirement stands; close: it holds with a margin below a tenth of the field or limit.
enum class Light { holds, close, undecided, fails };

inline constexpr double closeMargin = 0.1;

/// Whether it is met by a small margin. A setting of the machine is met up to the end of its range.
[[nodiscard]] bool isClose(const ConstraintResult& constraint);

/// Whether it is undecided: an estimate met by its lower end and not by its upper end.
[[nodiscard]] bool isOpen(const ConstraintResult& constraint);
/// Whether it holds by a value that does not include the machine's own form: the value is a lower
/// bound, and the requirement is not decided.
[[nodiscard]] bool isLowerBound(const ConstraintResult& constraint);

/// How far a margin is known.
enum class MarginKnown {
    exactly,
    atMost, ///< the value is a lower bound
    no      ///< value of a part of the surface, of an open estimate, or one that rounds to 0
};
[[nodiscard]] MarginKnown marginKnown(const ConstraintResult& constraint);
/// The margin as it is stated: of an estimate that is met, that of its upper end.
[[nodiscard]] double statedMargin(const ConstraintResult& constraint);

/// Whether the first is more important than the second: unmet before met, among the unmet the
/// overlap first, on which the others depend where strips stay uncut; then close before others;
/// then by the relative margin.
[[nodiscard]] bool isWorse(const ConstraintResult& first, const ConstraintResult& second);

/// The most important one: the worst unmet, otherwise the closest; null without any.
[[nodiscard]] const ConstraintResult*
worstRequirement(const std::vector<ConstraintResult>& constraints);

[[nodiscard]] Light lightOf(const ConstraintResult& constraint);

/// The verdict of a run: the worst of its requirements; a run that does not end by itself fails.
[[nodiscard]] Light verdictOf(RunStatus status, const std::vector<ConstraintResult>& constraints);

/// The used share of a tolerance or limit: 1 at the limit; of an estimate that is met, by its upper
/// end. For a setting, by the ratio to its limit or to the nearer end of its range: ½ for an
/// overlap twice the least one.
[[nodiscard]] double usageOf(const ConstraintResult& requirement);

/// The position of a setting within its range of the machine, from 0 to 1: by its ratios to the
/// ends, for a range from 0 by its distances. Empty for other requirements.
[[nodiscard]] std::optional<double> placeInRange(const ConstraintResult& requirement);

/// The margin of a setting of the machine as its ratio to the nearer end of its range: 2 for twice
/// the lower end, or half of the upper one; below 1 outside the range. Empty for other
/// requirements, and where the setting or that end is 0.
[[nodiscard]] std::optional<double> ratioInRange(const ConstraintResult& requirement);
/// Significant digits of such a ratio: 2, and more next to 1.
[[nodiscard]] int digitsOfRatio(double ratio);

} // namespace sparkout
