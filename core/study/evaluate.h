// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <stop_token>

namespace sparkout {

/// Checks a project, runs its cycle and checks the result against the drawing. Returns null when
/// stopped.
[[nodiscard]] OutcomePtr evaluate(const Project& project, const std::stop_token& stop = {});

} // namespace sparkout
