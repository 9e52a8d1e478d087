// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"
#include "core/quality/requirement.h"

#include <vector>

namespace sparkout {

/// The inputs behind a requirement's value that have no public source: estimates of the shop, to be
/// calibrated at the machine. Empty for a setting. Whether the project's values are measured does
/// not matter here.
[[nodiscard]] std::vector<const Field*> estimatesBehind(const Project& project,
                                                        ConstraintKind kind);

} // namespace sparkout
