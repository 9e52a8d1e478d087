// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <optional>
#include <string_view>

/// Names of the methods and outcomes of a search in `--method` and `--json`.
namespace sparkout {

[[nodiscard]] const char* searchMethodName(SearchMethod method);
[[nodiscard]] std::optional<SearchMethod> searchMethodNamed(std::string_view name);
[[nodiscard]] const char* searchStatusName(SearchStatus status);

} // namespace sparkout
