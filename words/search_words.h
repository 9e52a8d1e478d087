// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/grid_search.h"

#include <string>

namespace sparkout {

/// Why a method takes no such project, or its grid cannot be searched, as a sentence of the command
/// line and of the Python module: "/optimisation: …". Empty for a report that ran, and for one
/// whose project or batch has faults of its own, its `issues`.
[[nodiscard]] std::string searchRefusal(const GridSearchReport& report);

} // namespace sparkout
