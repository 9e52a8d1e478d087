// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/project/operation.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sparkout::cli {

/// A command with its operand and options, as typed.
struct Options {
    std::string command, operand;
    std::vector<std::string> operands; ///< after the first, of batch-merge
    std::string surface;               ///< a name, a number from 1 or "all"; empty: all
    std::string trace, measured, rows;
    std::string data, fit, loss, output, profile, trial, stiffness, indicator; ///< of measured
    bool roundness = false, sheet = false;                                     ///< of measured
    bool json = false, csv = false, check = false, progress = false, force = false;
    bool batch = false; ///< of simulate: the batch of the project is judged, too
    std::optional<int> parts, seed, threads, sensitivity;
    std::optional<std::pair<int, int>> shard; ///< I of N
    std::optional<double> untilWidth_um;
    std::optional<double> from_mm, to_mm;             ///< stocks, of phases
    std::optional<double> length_mm, stock_mm, ra_um; ///< of new
    std::optional<Operation> operation;               ///< of new
    std::string machine, wheel, material, shoulder;   ///< of new
    bool bore = false;                                ///< of new
    std::optional<Scenarios> scenarios;
};

/// Reads the arguments; what is wrong is said. Returns the exit status of it, or `done`.
[[nodiscard]] int parse(const std::vector<std::string>& arguments, Options& options);

} // namespace sparkout::cli
