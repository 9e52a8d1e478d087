// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `course check`: checks a lesson, a work, or the kept runs of a project with the engine.
int runCourseCheck(const manual::Given& given);

} // namespace sparkout::cli
