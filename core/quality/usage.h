// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <optional>

namespace sparkout {

/// How much of its field or limit a requirement uses up: 1 at the limit. Of a range of the machine
/// how close its nearer end is: half of a setting that is twice the least one.
[[nodiscard]] double usageOf(const ConstraintResult& requirement);

/// Where a setting lies in its range of the machine, from 0 to 1: by its ratios to the ends, of a
/// range from 0 by its distances. Nothing of other requirements.
[[nodiscard]] std::optional<double> placeInRange(const ConstraintResult& requirement);

} // namespace sparkout
