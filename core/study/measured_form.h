// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/machine.h"
#include "core/project/project.h"

#include <optional>

namespace sparkout {

/// Returns the form of the machine from measured parts: for each zone or section the mean of the
/// roundness deviations and of the radial runouts of the listed parts, or else of a summary. The
/// number of lobes is not measured. Empty unless one of the two was measured in every zone or
/// section.
[[nodiscard]] std::optional<MachineForm> measuredForm(const Project& project);

/// Returns the project whose machine has this form; a given number of lobes and direction stay.
[[nodiscard]] Project withMeasuredForm(Project project);

} // namespace sparkout
