// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/result.h"

#include <span>
#include <string>

namespace sparkout {

[[nodiscard]] std::span<const Output<PhaseDecision>> phasesOutputs();
[[nodiscard]] std::span<const Output<DecidedPiece>> phasePieceOutputs();
[[nodiscard]] std::span<const Output<FailingStocks>> failingStocksOutputs();
/// Returns the outputs of the requirement nearest to its limit in a piece or in failing stocks.
[[nodiscard]] std::span<const Output<ConstraintResult>> phaseWorstOutputs();

/// Returns the object of `phases --json`: the pieces of the range, and the stocks for which the
/// cycle fails.
[[nodiscard]] std::string phasesJson(const PhaseDecision& decision);

} // namespace sparkout
