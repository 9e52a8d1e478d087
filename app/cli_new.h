// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// Writes a project with a starting cycle for a drawing; returns the exit status.
[[nodiscard]] int runNewCommand(const manual::Given& given);

} // namespace sparkout::cli
