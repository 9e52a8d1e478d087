// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

namespace sparkout {

/// Faults of a project with a batch: its own, the batch's, and those of the extreme parts, each of
/// which must be a valid project. Empty: the batch can be run.
[[nodiscard]] Issues checkBatch(const Project& project);

} // namespace sparkout
