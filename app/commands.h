// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"

/// The commands of sparkout-cli that have a source of their own. Each returns the exit status.
namespace sparkout::cli {

[[nodiscard]] int runBatchCommand(const manual::Given& given);
[[nodiscard]] int runBatchMerge(const manual::Given& given);
/// The parts between two dressings of the wheel.
[[nodiscard]] int runDressingCommand(const manual::Given& given);
/// Writes a project with a starting cycle for a drawing.
[[nodiscard]] int runNewCommand(const manual::Given& given);
/// `optimize`; prints its progress to the standard error.
[[nodiscard]] int runOptimise(const manual::Given& given);
/// Decides for which stocks the cycle of each surface is fit.
[[nodiscard]] int runPhasesCommand(const manual::Given& given);
/// Which change of one setting makes an unfit cycle fit.
[[nodiscard]] int runRemediesCommand(const manual::Given& given);
[[nodiscard]] int runSweepCommand(const manual::Given& given);

} // namespace sparkout::cli
