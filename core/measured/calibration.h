// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/identification.h"
#include "core/project/measured.h"
#include "core/project/project.h"

#include <string>

namespace sparkout {

/// The project with the fitted inputs, each recorded as calibrated on these data
/// (`measured.calibrations`, one for each input: a later one replaces an earlier one). Offsets of
/// the traces are not inputs. Returns the project unchanged if nothing was fitted.
[[nodiscard]] Project withCalibration(const Project& project, const Identification& result,
                                      const std::string& data, const std::string& date);

/// Records the origin of an input's value.
void recordCalibration(Project& project, Calibration calibration);

[[nodiscard]] std::string today(); ///< today's date, UTC: "2026-03-05"

} // namespace sparkout
