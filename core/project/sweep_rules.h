// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

namespace sparkout {

/// What keeps the sweep of a project from being run: inputs that are no numbers of it, ranges
/// beyond what an input may be. None without a sweep. A single cycle does not read them.
[[nodiscard]] Issues sweepFaults(const Project& project);

} // namespace sparkout
