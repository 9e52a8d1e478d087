// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

namespace sparkout::cli {

/// `course variants`: a work for each student of a list, and the two tables.
int runCourseVariants(const manual::Given& given);

} // namespace sparkout::cli
