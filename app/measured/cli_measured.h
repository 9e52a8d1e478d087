// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `measured`; returns the exit status.
[[nodiscard]] int runMeasuredCommand(const manual::Given& given);

} // namespace sparkout::cli
