// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// withOperation() with the project as it last was under that operation: feeds come back as they
/// were there, and of ground length, wheel, overruns, compliance, gauge and surface what was not
/// touched since. There and back is the project it was.
[[nodiscard]] Project withOperation(const Project& project, Operation operation,
                                    const Project* last);

} // namespace sparkout
