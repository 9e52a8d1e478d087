// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"

#include <optional>
#include <span>
#include <vector>

namespace sparkout {

/// Correlates factors by a Gaussian copula: independent shares u become normal scores z = Φ⁻¹(u),
/// L·z with R = L·Lᵀ are scores of correlation R, and back to shares. R is the correlation of the
/// scores: of normal factors Pearson's own, of others the rank correlation is (6/π)·asin(R/2).
///
/// Not by Iman and Conover's reordering [IMAN1982]: that needs the whole sample at once, and a part
/// here must be known from its number alone. As a drawback, only the first factor of a Latin
/// hypercube keeps its strata exactly.
class Correlation {
public:
    /// Empty if the matrix is not positive definite. It must be square with ones on its diagonal.
    static std::optional<Correlation> of(const std::vector<std::vector<double>>& matrix);

    /// Turns independent shares into correlated ones.
    void apply(std::span<double> shares) const;

private:
    std::vector<std::vector<double>> m_lower; ///< L, row i of i + 1 values
};

} // namespace sparkout
