// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"

#include <string>

namespace sparkout::cli {

/// The text of an outcome with an answer.
[[nodiscard]] std::string optimiseText(const SearchOutcome& outcome);

} // namespace sparkout::cli
