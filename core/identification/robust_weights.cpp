// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/robust_weights.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

const char* keyOf(RobustLoss loss) {
    return loss == RobustLoss::huber ? "huber" : loss == RobustLoss::tukey ? "tukey" : "none";
}

std::vector<double> robustWeights(const std::vector<double>& residuals, RobustLoss loss) {
    constexpr double huber = 1.345, tukey = 4.685;
    std::vector<double> weights;
    weights.reserve(residuals.size());
    for (const double residual : residuals) {
        const double u = std::abs(residual);
        switch (loss) {
        case RobustLoss::none: weights.push_back(1); break;
        case RobustLoss::huber: weights.push_back(std::sqrt(huber / std::max(u, huber))); break;
        case RobustLoss::tukey: {
            const double rest = 1 - u * u / (tukey * tukey);
            weights.push_back(std::max(0.0, rest)); // the root of (1 − (u/c)²)²
            break;
        }
        }
    }
    return weights;
}

} // namespace sparkout
