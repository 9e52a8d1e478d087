// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"

#include <functional>
#include <string>

namespace sparkout {

/// All faults of a project, by the ranges of the tables and the rules between fields. Errors
/// prevent a run, warnings do not.
[[nodiscard]] Issues validate(const Project& project);

/// The allowed values of a field, for a message: its range, its choices or its type.
[[nodiscard]] Detail allowedIn(const Field& field);

/// The shortest digits that read back to the same double.
[[nodiscard]] std::string numberText(double value);

/// A range as text, "0.5…1000 mm", or its only value; an open end is marked, "> 0…5 mm".
[[nodiscard]] std::string rangeText(const Range& range, const char* unit,
                                    const std::function<std::string(double)>& number = numberText);

} // namespace sparkout
