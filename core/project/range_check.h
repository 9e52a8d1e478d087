// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

namespace sparkout {

/// Holds every member against the hard and soft range of its row.
[[nodiscard]] Issues checkRanges(const Project& project);

} // namespace sparkout
