// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `sweep`; returns the exit status.
[[nodiscard]] int runSweepCommand(const manual::Given& given);

} // namespace sparkout::cli
