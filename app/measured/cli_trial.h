// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/identification/fitted_parameter.h"
#include "core/project/project.h"

#include <string>
#include <vector>

namespace sparkout::cli {

/// `measured --trial`; returns the exit status.
[[nodiscard]] int designTrialOf(const Project& project, const std::string& name,
                                const std::vector<FittedParameter>& parameters,
                                const manual::Given& given);

} // namespace sparkout::cli
