// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"

#include <string>

namespace sparkout {

/// The object of `optimize --json`; its named keys are fixed.
[[nodiscard]] std::string searchJson(const SearchOutcome& outcome);

} // namespace sparkout
