// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/project/project.h"

#include <string>

namespace sparkout::cli {

/// `measured --roundness`, with `--profile` for a recorded section; returns the exit status.
[[nodiscard]] int stateRoundness(const Project& project, const std::string& name,
                                 const manual::Given& given);

} // namespace sparkout::cli
