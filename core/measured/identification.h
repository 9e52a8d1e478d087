// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/measured/fit_data.h"
#include "core/measured/fit_problem.h"
#include "core/measured/force_law_choice.h"
#include "core/measured/identifiability.h"
#include "core/measured/noise_model.h"
#include "core/statistics/intervals.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

/// Fits parameters of the process to measured cycles: nonlinear least squares on the simulated
/// cycle itself [MODEL-13].
namespace sparkout {

struct IdentificationRequest {
    std::vector<FittedParameter> parameters;
    std::vector<int> traces = {}; ///< indices in the project; empty: all
    bool withParts = false;       ///< includes the measured diameters
    RobustLoss loss = RobustLoss::none;
};

enum class IdentificationStatus {
    fitted,
    cannotTell,    ///< the data leave some parameters undetermined: no values
    noData,        ///< no data, or not enough, that depend on the parameters
    notApplicable, ///< compliances of places that the project does not have, a parameter twice, the
                   ///< setting of the gauge from traces
    notRun,        ///< the cycle of the project cannot be run
    notConverged,
    doesNotFit, ///< fitted, but the residuals exceed chance, a time is omitted, or a value lies
                ///< outside its usual range: not to be used
    stopped
};

struct FittedValue {
    FittedParameter parameter;
    double value = 1;
    Interval interval95;
    double error = 0;                ///< standard error: of a factor relative to it
    std::optional<Interval> usual{}; ///< usualRange() of the parameter

    [[nodiscard]] bool isUsual() const {
        return !usual || (usual->low <= value && value <= usual->high);
    }
};

/// A value of a trace with its time.
struct TraceReading {
    double time_s = 0;
    double value = 0;
};

/// The residuals of one group.
struct FitResiduals {
    FitSource source = FitSource::size;
    int trace = -1;
    std::vector<double> values; ///< measured less predicted, in the order of the data
    double rms = 0;
    double rounding = 0;               ///< of the simulation of a trace; a lower RMS means nothing
    std::optional<TraceNoise> noise{}; ///< noise of a trace, from differences of neighbours
    LackOfFit lack{};                  ///< lack of fit of a trace
    UnlikeCycle unlike{};              ///< cause of the lack of fit
    std::size_t outliers = 0;          ///< lone outliers, with a lower weight in the judgement
    std::vector<TraceReading> overRange{}; ///< lone values beyond the range of all others
};

struct Identification {
    IdentificationStatus status = IdentificationStatus::noData;
    std::vector<FittedValue> values;
    std::vector<std::vector<double>> covariance; ///< of the values; for factors of their logarithms
    std::vector<std::vector<double>> correlation;
    std::vector<FitResiduals> residuals;
    std::optional<Normality> normality; ///< for residuals divided by the RMS of their group
    std::vector<OutOfStep> outOfStep;   ///< omitted times, hardly 0: the model does not fit
    double condition = 1;
    std::vector<Unidentified> unidentified;
    std::vector<int> stepsByStage;          ///< steps of the fitted cycle, by stage
    std::optional<ForceLawChoice> forceLaw; ///< supported by its spark-out, if that is recorded
    std::vector<int> withoutFactor;         ///< omitted currents without a given factor; by index
    std::size_t count = 0;                  ///< measured values
    /// Why the cycle cannot be run, or refused and unusual inputs with these values.
    Issues issues;
};

[[nodiscard]] Identification identify(const Project& project, const IdentificationRequest& request,
                                      const std::stop_token& stop = {});

} // namespace sparkout
