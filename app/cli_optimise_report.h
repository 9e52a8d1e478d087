// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/grid_search.h"

#include <optional>
#include <string>

namespace sparkout::cli {

/// For people.
[[nodiscard]] std::string optimiseText(const GridSearchReport& report);

/// The object of `optimize --json`; its named keys are fixed.
[[nodiscard]] std::string optimiseJson(const GridSearchReport& report);

/// Why there is no answer, with the requirements that cut most.
[[nodiscard]] std::string noAnswerSentence(const GridSearchReport& report);

} // namespace sparkout::cli
