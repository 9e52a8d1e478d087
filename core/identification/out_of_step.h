// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_problem.h"
#include "core/identification/levenberg_marquardt.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace sparkout {

/// A property of the recorder that was not fitted and is hardly 0: a time of the traces against the
/// cycle (`time_shift`), of the power or the force against what else was recorded, lag or drift of
/// the gauge. Left out, it goes into the other parameters, whose intervals say nothing of it.
struct OutOfStep {
    FittedKind kind = FittedKind::power_delay;
    double amount = 0;         ///< with it fitted too
    double error = 0;          ///< its standard error; wider where the residuals follow each other
    std::size_t parameter = 0; ///< the one of the fit that it moves most, by its error
    double value = 0;          ///< what that one would be
};

/// The delay counts as real beyond so many standard errors: of normal noise one fit in 2,000.
inline constexpr double certainDelay = 3.5;
/// From so many on it may be real: the criterion of Akaike is for it.
inline constexpr double possibleDelay = 1.4;

/// What is known of the lag of a gauge that nobody stated: gauges filter over 0.05 to 0.3 s, so one
/// of twice this may well be there. An estimate.
inline constexpr double usualLag_s = 0.15;

/// What was left out of a fit.
struct LeftOut {
    std::vector<OutOfStep> certain;
    /// Fits with one more that may be real, or with a usual lag of the gauge that the data do not
    /// exclude: coordinates of the fitted parameters and the standard errors of these.
    struct Possible {
        std::vector<double> q, errors;
    };
    std::vector<Possible> possible;
};

/// Whether it is beyond `certainDelay` of its errors, and long enough for the clock of a recorder.
[[nodiscard]] bool isCertain(const OutOfStep& found);

/// The times that the data could tell and that are not fitted.
[[nodiscard]] std::vector<FittedKind> timesLeftOut(const FitData& data,
                                                   const std::vector<FittedParameter>& fitted);

/// Of residuals in the order of time: near 0 where they are noise alone.
[[nodiscard]] double firstAutocorrelation(std::span<const double> residuals);

/// By how much the variance of a mean is greater where each residual follows the one before:
/// (1 + ρ)/(1 − ρ) of the first autocorrelation ρ.
[[nodiscard]] double inflation(double autocorrelation);

/// Of a fit at its best: each time left out is fitted
/// beside the rest, with the same steps and weights.
[[nodiscard]] LeftOut outOfStep(const Project& project, const FitData& data,
                                const FitProblem& fitted, const LeastSquares& best,
                                const std::vector<double>& errors, const std::stop_token& stop);

} // namespace sparkout
