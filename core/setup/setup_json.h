// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup_run.h"

#include <string>

namespace sparkout {

/// One JSON object: "surfaces", each with its name and the keys of resultJson(), and "part" with
/// completed, holds and the times, which are null unless every surface is completed.
[[nodiscard]] std::string setupJson(const Setup& setup, const SetupRun& run);

} // namespace sparkout
