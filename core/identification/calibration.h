// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/project/measured.h"
#include "core/project/project.h"

#include <string>

namespace sparkout {

/// The project with the inputs that a fit has found, each of them recorded as calibrated on these
/// data (`measured.calibrations`, one an input: a later one takes the place of an earlier one).
/// Offsets of the traces are no inputs. The project itself where nothing was fitted.
[[nodiscard]] Project withCalibration(const Project& project, const Identification& result,
                                      const std::string& data, const std::string& date);

/// Records where the value of one input comes from.
void recordCalibration(Project& project, Calibration calibration);

} // namespace sparkout
