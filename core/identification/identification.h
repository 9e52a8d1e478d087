// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/identification/fitted_parameter.h"
#include "core/identification/identifiability.h"
#include "core/identification/out_of_step.h"
#include "core/identification/robust_weights.h"
#include "core/issue.h"
#include "core/statistics/intervals.h"
#include "core/statistics/normality.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

/// Parameters of the process from measured cycles: nonlinear least squares on the simulated cycle
/// itself [MODEL-13].
namespace sparkout {

struct IdentificationRequest {
    std::vector<FittedParameter> parameters;
    std::vector<int> traces = {}; ///< by their numbers in the project; empty: all
    bool withParts = false;       ///< the measured diameters too
    RobustLoss loss = RobustLoss::none;
};

enum class IdentificationStatus {
    fitted,
    cannotTell,    ///< the data do not tell some of the parameters: no values
    noData,        ///< nothing measured that the parameters act on, or less than there are
    notApplicable, ///< compliances of places that the project cannot have, a parameter twice
    notRun,        ///< the cycle of the project cannot be run
    notConverged,
    againstGauge, ///< of finished parts alone: where they fit, the gauge ends the cycle elsewhere
    stopped
};

struct FittedValue {
    FittedParameter parameter;
    double value = 1;
    Interval interval95;
    double error = 0; ///< standard error: of a factor relative to it
};

/// How the values of one group are met.
struct FitResiduals {
    FitSource source = FitSource::size;
    int trace = -1;
    std::vector<double> values; ///< measured less predicted, in the order of the data
    double rms = 0;
    std::optional<double> noise; ///< of a trace, from the trace itself

    /// Whether more is left than the noise of the trace: the cycle that was run is not the one that
    /// was recorded, whatever its parameters.
    [[nodiscard]] bool isInDoubt() const;
};

/// The RMS of a fit of the right cycle is about the noise of the trace, not above this times it.
inline constexpr double mostRmsOfNoise = 1.3;

struct Identification {
    IdentificationStatus status = IdentificationStatus::noData;
    std::vector<FittedValue> values;
    std::vector<std::vector<double>> covariance; ///< of the values; of factors of their logarithms
    std::vector<std::vector<double>> correlation;
    std::vector<FitResiduals> residuals;
    std::optional<Normality> normality; ///< of the residuals, each by the RMS of its group
    std::vector<OutOfStep> outOfStep;   ///< times left out that are hardly 0: the values are wrong
    double condition = 1;
    std::vector<Unidentified> unidentified;
    std::vector<int> stepsByStage;  ///< of the cycle that fits
    std::vector<int> withoutFactor; ///< currents left out, as their factor is not given; by number
    std::size_t count = 0;          ///< measured values
    Issues issues;                  ///< why the cycle cannot be run

    [[nodiscard]] bool isInDoubt() const; ///< for the residuals of any trace
};

[[nodiscard]] Identification identify(const Project& project, const IdentificationRequest& request,
                                      const std::stop_token& stop = {});

} // namespace sparkout
