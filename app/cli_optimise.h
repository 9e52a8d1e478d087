// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `optimize`; returns the exit status. Progress is printed to the standard error.
[[nodiscard]] int runOptimise(const manual::Given& given);

} // namespace sparkout::cli
