// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// Decides for which stocks the cycle of each surface is fit; returns the exit status.
[[nodiscard]] int runPhasesCommand(const manual::Given& given);

} // namespace sparkout::cli
