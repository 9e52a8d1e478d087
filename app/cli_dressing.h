// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `dressing`: the parts between two dressings of the wheel. Returns the exit status.
[[nodiscard]] int runDressingCommand(const manual::Given& given);

} // namespace sparkout::cli
