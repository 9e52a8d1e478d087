// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"
#include "core/project/project.h"

#include <string_view>

namespace sparkout {

/// The record of the input at a path; null: it was not calibrated.
[[nodiscard]] const Calibration* calibrationOf(const Project& project, std::string_view path);

/// Whether the input still has the value that was found. A value set by hand since, or an input
/// that the project does not have any more, keeps its record, but it is not calibrated.
[[nodiscard]] bool hasCalibratedValue(const Project& project, const Calibration& calibration);

/// Whether an input rests on a calibration: every record of it still holds. A compliance that is
/// computed rests on those of what it is computed from.
[[nodiscard]] bool isCalibrated(const Project& project, const Field& input);

} // namespace sparkout
