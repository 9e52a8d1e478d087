// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/identification/fitted_parameter.h"
#include "core/identification/force_law_choice.h"
#include "core/identification/identifiability.h"
#include "core/identification/noise_model.h"
#include "core/identification/out_of_step.h"
#include "core/identification/robust_weights.h"
#include "core/identification/unlike.h"
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
    notApplicable, ///< compliances of places that the project cannot have, a parameter twice, the
                   ///< setting of the gauge from traces
    notRun,        ///< the cycle of the project cannot be run
    notConverged,
    doesNotFit, ///< values are there, and what they leave is more than chance: not to be used
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
    std::optional<TraceNoise> noise{}; ///< of a trace, from what neighbours differ by
    LackOfFit lack{};                  ///< of it
    UnlikeCycle unlike{};              ///< where it lacks
    std::size_t outliers = 0; ///< lone ones that a robust loss counts less in what is judged
};

/// A fit of traces begins all over factors from as little to as much; what it finds beyond them is
/// not used: the inputs are to be brought nearer first.
inline constexpr double mostSearchedFactor = 4;

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
    std::vector<int> stepsByStage;          ///< of the cycle that fits
    std::optional<ForceLawChoice> forceLaw; ///< that its spark-out supports, where it is recorded
    std::vector<int> withoutFactor; ///< currents left out, as their factor is not given; by number
    std::size_t count = 0;          ///< measured values
    /// Why the cycle cannot be run, or what is refused or unusual of the inputs with these values.
    Issues issues;
};

[[nodiscard]] Identification identify(const Project& project, const IdentificationRequest& request,
                                      const std::stop_token& stop = {});

} // namespace sparkout
