// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/grading.h"

#include <string>

/// The objects of `course check --json`.
namespace sparkout {

[[nodiscard]] std::string lessonCheckJson(const CheckedSteps& checked);
[[nodiscard]] std::string workCheckJson(const Work& work, const CheckedSteps& checked);

} // namespace sparkout
