// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `batch` and `batch-merge`; return the exit status.
[[nodiscard]] int runBatchCommand(const manual::Given& given);
[[nodiscard]] int runBatchMerge(const manual::Given& given);

} // namespace sparkout::cli
