// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"

#include <functional>

namespace sparkout {

/// What of a batch fails by the stock of its parts alone, their other inputs as they are.
struct FailingShare {
    double failing = 0;   ///< share of all parts whose stock fails
    double undecided = 0; ///< share whose stock lies outside the range decided
};

/// Of a decision, by the distribution of the stock: F(x) the share of parts of a smaller stock,
///
///     failing = Σ (F(to) − F(from)) over the stocks that fail,  undecided = 1 − (F(to) − F(from))
///
/// of the range. Where neighbouring pieces overlap a stock counts once. No stock is sampled.
[[nodiscard]] FailingShare failingShare(const PhaseDecision& decision,
                                        const std::function<double(double stock_mm)>& shareBelow);

} // namespace sparkout
