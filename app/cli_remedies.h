// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `remedies`: which change of one setting makes an unfit cycle fit. Returns the exit status.
[[nodiscard]] int runRemediesCommand(const manual::Given& given);

} // namespace sparkout::cli
