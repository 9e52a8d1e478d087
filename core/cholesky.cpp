// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cholesky.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace sparkout {

std::optional<std::vector<std::vector<double>>>
choleskyFactor(const std::vector<std::vector<double>>& matrix) {
    constexpr double leastPivot = 1e-12;
    std::vector<std::vector<double>> lower;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        std::vector<double> row(i + 1);
        for (std::size_t j = 0; j <= i; ++j) {
            double rest = matrix[i][j];
            for (std::size_t k = 0; k < j; ++k) {
                rest -= row[k] * (j < i ? lower[j][k] : row[k]);
            }
            if (j < i) {
                row[j] = rest / lower[j][j];
            } else if (!(rest >= leastPivot)) {
                return std::nullopt;
            } else {
                row[j] = std::sqrt(rest);
            }
        }
        lower.push_back(std::move(row));
    }
    return lower;
}

} // namespace sparkout
