// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/io/cli_options.h"

namespace sparkout::cli {

/// `dressing`: the parts between two dressings of the wheel. Returns the exit status.
[[nodiscard]] int runDressingCommand(const Options& options);

} // namespace sparkout::cli
