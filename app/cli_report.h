// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/digits.h"
#include "core/issue.h"
#include "core/quality/constraints.h"
#include "core/setup/setup_run.h"
#include "core/simulation/result.h"

#include <string>

namespace sparkout::cli {

/// One line for each fault: "FILE: /path: sentence".
[[nodiscard]] std::string issueLine(const std::string& file, const Issue& issue);

/// A result as text, with its judgement in words; judgedResultJson() is its counterpart for
/// programs.
[[nodiscard]] std::string resultText(const SimulationResult& result,
                                     const std::vector<ConstraintResult>& constraints,
                                     const std::string& headline);

/// "fit for every stock of 0.1480…0.1520 mm", "unfit for stocks of 0.1500…0.1510 mm".
[[nodiscard]] std::string fitForStocks(bool isFit, const std::string& stocks);

/// The times of the part after those of its surfaces, and whether all surfaces are fit.
[[nodiscard]] std::string setupText(const Setup& setup, const SetupRun& run);

/// The reason why a run is not completed, with the size reached.
[[nodiscard]] std::string statusSentence(const SimulationResult& result);

/// The CSV of `simulate --trace`: a row for each visit.
[[nodiscard]] std::string traceCsv(const SimulationResult& result, const Trajectory& trajectory);

} // namespace sparkout::cli
