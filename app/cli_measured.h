// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/measured/fit_data.h"
#include "core/project/project.h"

#include <string>
#include <vector>

/// The command `measured` and its parts. Each returns the exit status.
namespace sparkout::cli {

[[nodiscard]] int runMeasuredCommand(const manual::Given& given);

/// `measured --roundness`, with `--profile` for a recorded section.
[[nodiscard]] int stateRoundness(const Project& project, const std::string& name,
                                 const manual::Given& given);

/// `measured --stiffness` and `--stiffness-sheet`.
[[nodiscard]] int findStiffness(const Project& project, const std::string& name,
                                const manual::Given& given);

/// `measured --trial`.
[[nodiscard]] int designTrialOf(const Project& project, const std::string& name,
                                const std::vector<FittedParameter>& parameters,
                                const manual::Given& given);

} // namespace sparkout::cli
