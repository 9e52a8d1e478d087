// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/fit_problem.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace sparkout {

/// A property of the recorder that was not fitted and is probably not 0: a shift of the traces
/// relative to the cycle (`time_shift`), a delay of the power or the force relative to other
/// traces, lag or drift of the gauge, the filter of the power or the force. If omitted, it biases
/// the other parameters, whose intervals do not show it.
struct OutOfStep {
    FittedKind kind = FittedKind::power_delay;
    double amount = 0;         ///< value in a fit that includes it
    double error = 0;          ///< its standard error; wider if the residuals are correlated
    std::size_t parameter = 0; ///< the fitted one that it changes most, relative to its error
    double value = 0;          ///< value of that parameter with it
};

/// The number of standard errors beyond which a delay counts as real: exceeded by normal noise in
/// one of 2,000 fits.
inline constexpr double certainDelay = 3.5;
/// The number from which it may be real: Akaike's criterion supports it.
inline constexpr double possibleDelay = 1.4;

/// The properties of the recorder omitted from a fit.
struct LeftOut {
    std::vector<OutOfStep> certain;
    /// Fits with an additional property that may be real, or with a usual lag of the gauge that the
    /// data do not exclude: coordinates of the fitted parameters and their standard errors.
    struct Possible {
        std::vector<double> q, errors;
    };
    std::vector<Possible> possible;
};

/// Whether it exceeds `certainDelay` standard errors, and the resolution of a recorder's clock; no
/// lag is negative: that would be a delay.
[[nodiscard]] bool isCertain(const OutOfStep& found);

/// Of a delay and a filter of the same trace, which look alike, the one with more standard errors.
[[nodiscard]] std::vector<OutOfStep> clearest(std::vector<OutOfStep> found);

/// The times that the data could determine and that are not fitted.
[[nodiscard]] std::vector<FittedKind> timesLeftOut(const FitData& data,
                                                   const std::vector<FittedParameter>& fitted);

/// For residuals in the order of time: near 0 for white noise.
[[nodiscard]] double firstAutocorrelation(std::span<const double> residuals);

/// The factor on the variance of a mean of correlated residuals: (1 + ρ)/(1 − ρ) for the first
/// autocorrelation ρ.
[[nodiscard]] double inflation(double autocorrelation);

/// For a fit at its best: fits each omitted time besides the rest, with the same steps and weights.
[[nodiscard]] LeftOut outOfStep(const Project& project, const FitData& data,
                                const FitProblem& fitted, const LeastSquares& best,
                                const std::vector<double>& errors, const std::stop_token& stop);

/// The noise of a trace: a white one and a correlated one, cov(k) = w·[k = 0] + s·φ^k for values k
/// apart.
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
    /// The variance of the mean of this many successive values.
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
