// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fitted_parameter.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// "compliance:2,alpha" as parameters; nothing where one of them is none.
[[nodiscard]] std::optional<std::vector<FittedParameter>> parametersOf(const std::string& text);

/// Says which parameters the option takes; returns the exit status of it.
int refuseParameters(const std::string& option);

[[nodiscard]] std::string parameterName(const FittedParameter& parameter);

} // namespace sparkout::cli
