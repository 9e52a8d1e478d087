// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace sparkout {

enum class RobustLoss { none, huber, tukey };
[[nodiscard]] const char* keyOf(RobustLoss loss); ///< "huber"

/// Roots of the weights ψ(u)/u of residuals in units of their noise, by which the residuals are
/// multiplied in the next step of reweighted least squares: Huber's with 1.345, Tukey's with 4.685,
/// both 95 % efficient for normal noise [HUBER1981].
[[nodiscard]] std::vector<double> robustWeights(const std::vector<double>& residuals,
                                                RobustLoss loss);

} // namespace sparkout
