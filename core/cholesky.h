// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace sparkout {

/// The lower triangle L of A = L·Lᵀ, row i with i + 1 values; empty if A, square and symmetric with
/// ones on its diagonal, is not positive definite.
[[nodiscard]] std::optional<std::vector<std::vector<double>>>
choleskyFactor(const std::vector<std::vector<double>>& matrix);

} // namespace sparkout
