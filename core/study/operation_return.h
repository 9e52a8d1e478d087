// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// Like withOperation(), but restores from `last`, the project's last state under that operation,
/// the feeds and those inputs of ground length, wheel, overruns, compliance, gauge and surface that
/// were not edited since. Switching there and back gives the same project.
[[nodiscard]] Project withOperation(const Project& project, Operation operation,
                                    const Project* last);

} // namespace sparkout
