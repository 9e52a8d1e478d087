// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

namespace sparkout {

/// The faults that prevent the sweep of a project: inputs that are not its numbers, ranges beyond
/// what an input allows. Empty without a sweep. A single cycle does not need them.
[[nodiscard]] Issues sweepFaults(const Project& project);

} // namespace sparkout
