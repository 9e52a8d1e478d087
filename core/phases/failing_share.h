// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"

#include <functional>

namespace sparkout {

/// Share of a batch that fails because of the stock alone, with the other inputs unchanged.
struct FailingShare {
    double failing = 0;   ///< share of parts with a failing stock
    double undecided = 0; ///< share of parts with a stock outside the decided range
};

/// Computes the shares from a decision and the distribution of the stock, F(x) being the share of
/// parts with a smaller stock:
///
///     failing = Σ (F(to) − F(from)) over the stocks that fail,  undecided = 1 − (F(to) − F(from))
///
/// of the range. A stock in overlapping pieces counts once. No stock is sampled.
[[nodiscard]] FailingShare failingShare(const PhaseDecision& decision,
                                        const std::function<double(double stock_mm)>& shareBelow);

} // namespace sparkout
