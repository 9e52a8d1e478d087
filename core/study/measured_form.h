// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/machine.h"
#include "core/project/project.h"

#include <optional>

namespace sparkout {

/// The form of the machine that measured parts show: by zone or section the mean of the roundness
/// deviations and of the radial runouts, of the listed parts, else of a summary. The number of
/// lobes is not among what was measured. Empty where neither was measured in every zone or section.
[[nodiscard]] std::optional<MachineForm> measuredForm(const Project& project);

/// The project whose machine prints it; the number of lobes and the direction that are given stay.
[[nodiscard]] Project withMeasuredForm(Project project);

} // namespace sparkout
