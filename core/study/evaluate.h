// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <stop_token>

namespace sparkout {

/// Checks a project, runs its cycle and holds it against the drawing. Null when stopped.
[[nodiscard]] OutcomePtr evaluate(const Project& project, const std::stop_token& stop = {});

} // namespace sparkout
