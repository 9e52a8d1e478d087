// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/io/cli_options.h"

namespace sparkout::cli {

/// `measured`; returns the exit status.
[[nodiscard]] int runMeasuredCommand(const Options& options);

} // namespace sparkout::cli
