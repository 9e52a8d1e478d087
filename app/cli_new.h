// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/io/cli_options.h"

namespace sparkout::cli {

/// Writes a project with a starting cycle for a drawing; the exit status.
[[nodiscard]] int runNewCommand(const Options& options);

} // namespace sparkout::cli
