// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// A small complete cycle of each operation, to start from.
[[nodiscard]] Project newProject(Operation operation = {});

} // namespace sparkout
