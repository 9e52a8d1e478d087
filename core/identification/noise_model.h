// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sparkout {

/// The noise of a trace: a white one and one that follows itself, cov(k) = w·[k = 0] + s·φ^k for
/// values k apart.
struct TraceNoise {
    double white = 0;     ///< w, a variance
    double following = 0; ///< s, a variance
    double phi = 0;       ///< φ, below 1
    /// Of the error of rounding, which may be the same all along a stage where the size changes by
    /// whole steps from value to value: step²/12·exp(−4π²·σ²/step²), σ the noise that was rounded.
    double held = 0;

    [[nodiscard]] double variance() const { return white + following; }
    /// Of the variance, what follows itself.
    [[nodiscard]] double share() const { return variance() > 0 ? following / variance() : 0; }
    /// Of the mean of so many values in a row.
    [[nodiscard]] double varianceOfMean(std::size_t count) const;
};

/// From what neighbours differ by, ½·mean (r_{t+k} − r_t)² = w + s·(1 − φ^k), k up to 12, so that
/// what changes slowly over the trace does not count as noise. φ is such that values a 25th of the
/// trace apart hardly know of each other: a noise slower than that cannot be told from a model that
/// does not fit. Never below the variance of rounding to `step`, step²/12. At least 3 values.
[[nodiscard]] TraceNoise traceNoiseOf(std::span<const double> residuals, double step = 0);

/// Of the means of stretches of the residuals: their mean square over what the noise gives them,
/// of so many degrees of freedom; about 1 where nothing but noise is left.
struct LackOfFit {
    double ratio = 1;
    double freedom = 1;
    double most = 1; ///< that chance leaves, in 99 of 100 fits
    [[nodiscard]] bool isLacking() const { return ratio > most; }
};
[[nodiscard]] LackOfFit lackOfFit(std::span<const double> residuals, const TraceNoise& noise,
                                  double parametersOfGroup);

/// A row of a matrix of derivatives of residuals by p parameters, a column each.
struct Derivatives {
    std::span<const double> columns;
    std::size_t rows = 0;
    [[nodiscard]] std::size_t parameters() const { return columns.size() / rows; }
    [[nodiscard]] double at(std::size_t parameter, std::size_t row) const {
        return columns[parameter * rows + row];
    }
};

/// Σ_ij J_i·ρ(i, j)·J_jᵀ of the derivatives J of the rows [first, end) by their noise, ρ the
/// correlation of the noise: added to `sum`, p × p, row by row. `stages`: where the rows of the
/// next stage begin.
void addFollowing(const Derivatives& derivatives, std::size_t first, std::size_t end,
                  const std::vector<std::size_t>& stages, const TraceNoise& noise,
                  std::vector<double>& sum);

} // namespace sparkout
