// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/quality/constraints.h"
#include "core/simulation/result.h"
#include "core/simulation/trajectory.h"

#include <string>

namespace sparkout::cli {

/// One line a fault: "FILE: /path: sentence".
[[nodiscard]] std::string issueLine(const std::string& file, const Issue& issue);

/// Where in the cycle, as the command line says it: "nz E1 stage 1 double stroke 27".
[[nodiscard]] std::string placeText(const Place& place);

/// So many decimals, with a point, whatever the locale; never "-0".
[[nodiscard]] std::string fixed(double value, int decimals);

/// The object of `simulate --json`; its named keys are fixed.
[[nodiscard]] std::string resultJson(const SimulationResult& result,
                                     const std::vector<ConstraintResult>& constraints);

/// The same for people.
[[nodiscard]] std::string resultText(const SimulationResult& result,
                                     const std::vector<ConstraintResult>& constraints);

/// Why a run that is not completed ended, with the size reached.
[[nodiscard]] std::string statusSentence(const SimulationResult& result);

/// The CSV of `simulate --trace`: a row a visit.
[[nodiscard]] std::string traceCsv(const SimulationResult& result, const Trajectory& trajectory);

} // namespace sparkout::cli
