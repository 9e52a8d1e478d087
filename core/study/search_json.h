// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"

#include <string>

namespace sparkout {

/// Returns the object of `optimize --json`; its keys are fixed.
[[nodiscard]] std::string searchJson(const SearchOutcome& outcome);

} // namespace sparkout
