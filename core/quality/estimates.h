// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"
#include "core/quality/requirement.h"

#include <vector>

namespace sparkout {

/// The inputs behind a requirement's value for which there is no public source: estimates of the
/// shop, to be calibrated at the machine. None behind a setting. The project's own values, which do
/// not count here, may of course be measured ones.
[[nodiscard]] std::vector<const Field*> estimatesBehind(const Project& project,
                                                        ConstraintKind kind);

} // namespace sparkout
