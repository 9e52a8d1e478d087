// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/grid_search.h"

#include <optional>
#include <string>

namespace sparkout::cli {

/// A method as `--method` names it.
[[nodiscard]] const char* methodName(SearchMethod method);
[[nodiscard]] std::optional<SearchMethod> methodNamed(const std::string& name);

/// For people.
[[nodiscard]] std::string optimiseText(const GridSearchReport& report);

/// The object of `optimize --json`; its named keys are fixed.
[[nodiscard]] std::string optimiseJson(const GridSearchReport& report);

/// Why there is no answer, with the requirements that cut most.
[[nodiscard]] std::string noAnswerSentence(const GridSearchReport& report);

} // namespace sparkout::cli
