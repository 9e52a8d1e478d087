// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"
#include "core/project/project.h"

#include <string_view>

namespace sparkout {

/// The record of the input at a path; null if it was not calibrated.
[[nodiscard]] const Calibration* calibrationOf(const Project& project, std::string_view path);

/// Whether the input still has the fitted value. A record is kept when the value is changed by
/// hand, or when the project no longer has the input, but then the input is not calibrated.
[[nodiscard]] bool hasCalibratedValue(const Project& project, const Calibration& calibration);

/// Whether an input is based on a calibration whose records are all still valid. A computed
/// compliance depends on the records of its inputs.
[[nodiscard]] bool isCalibrated(const Project& project, const Field& input);

} // namespace sparkout
