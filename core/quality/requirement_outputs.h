// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/result.h"

#include <span>

namespace sparkout {

/// A requirement held against what the cycle makes.
[[nodiscard]] std::span<const Output<ConstraintResult>> requirementOutputs();

} // namespace sparkout
