// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/correlation.h"

#include "core/cholesky.h"
#include "core/statistics/intervals.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sparkout {

std::optional<Correlation> Correlation::of(const std::vector<std::vector<double>>& matrix) {
    auto lower = choleskyFactor(matrix);
    if (!lower) {
        return std::nullopt;
    }
    Correlation found;
    found.m_lower = std::move(*lower);
    return found;
}

void Correlation::apply(std::span<double> shares) const {
    std::vector<double> scores;
    for (const double share : shares) {
        scores.push_back(normalQuantile(share));
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        double score = 0;
        for (std::size_t k = 0; k <= i; ++k) {
            score += m_lower[i][k] * scores[k];
        }
        shares[i] = std::clamp(normalShare(score), 0x1p-60, 1 - 0x1p-53);
    }
}

} // namespace sparkout
