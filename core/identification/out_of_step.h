// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_problem.h"
#include "core/identification/levenberg_marquardt.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace sparkout {

/// A property of the recorder that was not fitted and is probably not 0: a shift of the traces
/// relative to the cycle (`time_shift`), a delay of the power or the force relative to other
/// traces, lag or drift of the gauge. If omitted, it biases the other parameters, whose intervals
/// do not show it.
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

/// Prior for the lag of a gauge that is not given: gauges filter over 0.05 to 0.3 s, so twice this
/// value is plausible. An estimate.
inline constexpr double usualLag_s = 0.15;

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

/// Whether it exceeds `certainDelay` standard errors, and the resolution of a recorder's clock.
[[nodiscard]] bool isCertain(const OutOfStep& found);

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

} // namespace sparkout
