// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `course grade`: marks the works of a folder.
int runCourseGrade(const manual::Given& given);

} // namespace sparkout::cli
