// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/result.h"

#include <span>

namespace sparkout {

/// The result of a requirement for a cycle.
[[nodiscard]] std::span<const Output<ConstraintResult>> requirementOutputs();

} // namespace sparkout
