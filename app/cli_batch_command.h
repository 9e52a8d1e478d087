// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/io/cli_options.h"

namespace sparkout::cli {

/// `batch` and `batch-merge`; return the exit status.
[[nodiscard]] int runBatchCommand(const Options& options);
[[nodiscard]] int runBatchMerge(const Options& options);

} // namespace sparkout::cli
