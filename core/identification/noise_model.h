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
    /// The part of the rounding error that may be constant along a stage whose size changes by
    /// whole steps from value to value: step²/12·exp(−4π²·σ²/step²), σ the noise before rounding.
    double held = 0;

    [[nodiscard]] double variance() const { return white + following; }
    /// The correlated share of the variance.
    [[nodiscard]] double share() const { return variance() > 0 ? following / variance() : 0; }
    /// The variance of the mean of so many successive values.
    [[nodiscard]] double varianceOfMean(std::size_t count) const;
};

/// Estimates the noise from differences of neighbours, ½·mean (r_{t+k} − r_t)² = w + s·(1 − φ^k), k
/// up to 12, so that slow changes over the trace do not count as noise. φ is such that values a
/// 25th of the trace apart are nearly independent: slower noise cannot be distinguished from a
/// wrong model. At least the variance of rounding to `step`, step²/12. Requires 3 values.
[[nodiscard]] TraceNoise traceNoiseOf(std::span<const double> residuals, double step = 0);

/// Lack of fit by the means of sections of the residuals: their mean square relative to the noise,
/// with its degrees of freedom; about 1 if only noise is left.
struct LackOfFit {
    double ratio = 1;
    double freedom = 1;
    double most = 1; ///< limit in 99 of 100 fits by chance
    [[nodiscard]] bool isLacking() const { return ratio > most; }
};
[[nodiscard]] LackOfFit lackOfFit(std::span<const double> residuals, const TraceNoise& noise,
                                  double parametersOfGroup);

/// A row of the derivatives of residuals by p parameters, one for each column.
struct Derivatives {
    std::span<const double> columns;
    std::size_t rows = 0;
    [[nodiscard]] std::size_t parameters() const { return columns.size() / rows; }
    [[nodiscard]] double at(std::size_t parameter, std::size_t row) const {
        return columns[parameter * rows + row];
    }
};

/// Adds Σ_ij J_i·ρ(i, j)·J_jᵀ of the derivatives J of the rows [first, end), divided by their
/// noise, to `sum`, p × p, row by row; ρ is the correlation of the noise. `stages`: first rows of
/// the later stages.
void addFollowing(const Derivatives& derivatives, std::size_t first, std::size_t end,
                  const std::vector<std::size_t>& stages, const TraceNoise& noise,
                  std::vector<double>& sum);

/// Lone values that lie beyond the range of all others by more than that range and that the model
/// does not predict, as a sensor at the end of its range gives them: their indices. `values` and
/// `residuals` belong to the same times; none of fewer than 20 values.
[[nodiscard]] std::vector<std::size_t> overRange(std::span<const double> values,
                                                 std::span<const double> residuals);

/// The cause of a trace's lack of fit.
enum class Unlike {
    drift, ///< the difference grows with time
    lag,   ///< proportional to the speed, or to changes of speed, of the trace
    stage, ///< misfit in one stage
    spike, ///< misfit in a few values
    other,
    count_
};

struct UnlikeCycle {
    Unlike kind = Unlike::other;
    int stage = -1; ///< index, from 0
};

/// For a trace whose residuals exceed noise, the cause that explains most of their squares; `other`
/// if none explains two fifths of the excess over the noise. `predicted`: at the same times;
/// `stageEnds_s`: in the time of the trace.
[[nodiscard]] UnlikeCycle unlikeOf(std::span<const double> time_s,
                                   std::span<const double> predicted,
                                   std::span<const double> residuals, double noiseVariance,
                                   const std::vector<double>& stageEnds_s);

} // namespace sparkout
