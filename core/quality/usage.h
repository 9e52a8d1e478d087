// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <optional>

namespace sparkout {

/// The used share of a tolerance or limit: 1 at the limit; of an estimate that is met, by its upper
/// end. For a setting, by the ratio to its limit or to the nearer end of its range: ½ for an overlap
/// twice the least one.
[[nodiscard]] double usageOf(const ConstraintResult& requirement);

/// The position of a setting within its range of the machine, from 0 to 1: by its ratios to the
/// ends, for a range from 0 by its distances. Empty for other requirements.
[[nodiscard]] std::optional<double> placeInRange(const ConstraintResult& requirement);

} // namespace sparkout
