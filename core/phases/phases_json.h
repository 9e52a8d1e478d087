// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"

#include <string>

namespace sparkout {

/// The object of `phases --json`: the pieces of the range, and the stocks for which the cycle
/// fails.
[[nodiscard]] std::string phasesJson(const PhaseDecision& decision);

} // namespace sparkout
