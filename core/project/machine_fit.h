// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

namespace sparkout {

/// The sizes of part and wheel that the machine does not take, each as a warning with the input
/// that determines the limit as the field of its bounds. A wheel without a bore in its marking fits
/// every seat.
[[nodiscard]] Issues machineMisfits(const Project& project);

/// Whether a misfit is of the part, not of the wheel.
[[nodiscard]] bool isPartMisfit(const Issue& misfit);

} // namespace sparkout
