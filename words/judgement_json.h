// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>

namespace sparkout {

/// A decision on the stocks; empty if there is none.
using StocksDecision = std::optional<JudgedStocks>;

[[nodiscard]] std::span<const Output<Judgement>> judgementOutputs();
[[nodiscard]] std::span<const Output<StocksDecision>> judgedStocksOutputs();
[[nodiscard]] std::span<const Output<JudgedBatch>> judgedBatchOutputs();

/// The object of `simulate --json`: that of resultJson() and, under "judged", the judgement of the
/// cycle for every stock within one infeed and, if it was run, for the batch:
///
///     { "state", "headline", "nominal",
///       "stocks": { "decided", "holds", "stock_mm", "failing_share", "worst" },
///       "batch": null or { "parts", "seed", "bad", "interval_95" },
///       "not_decided": [ { "name", "why", "input" }, … ] }
///
/// "worst" is an element of "constraints".
[[nodiscard]] std::string judgedResultJson(const SimulationResult& result,
                                           const std::vector<ConstraintResult>& constraints,
                                           const Judgement& judgement);

} // namespace sparkout
