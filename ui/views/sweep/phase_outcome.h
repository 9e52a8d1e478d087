// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/project/project.h"

#include <memory>

namespace sparkout {

/// The result of checking all stocks of a project: an immutable value.
struct PhaseOutcome {
    Project project;
    PhaseDecision decision;
};

using PhaseOutcomePtr = std::shared_ptr<const PhaseOutcome>;

} // namespace sparkout
