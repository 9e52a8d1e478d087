// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

namespace sparkout {

/// Faults of a batch that can be found without making its parts: forms, bounds and the correlation
/// matrix. A single cycle does not use them, so validate() only warns about them.
[[nodiscard]] Issues batchFaults(const Project& project);

} // namespace sparkout
