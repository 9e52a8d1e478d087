// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/fit_data.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

/// Designs the short trial that is most informative about parameters of the process, before any is
/// ground [MODEL-13].
namespace sparkout {

/// The recorded quantities of a trial.
enum class TrialRecord { size, power, sizeAndPower, force, count_ };

enum class TrialSparkOut {
    none,
    untilSettled, ///< steps until the deflection is a twentieth of the initial one
    count_
};

/// The noise of gauge, drive and force sensor.
struct TrialNoise {
    double hertz = 20;
    double size_mm = 1e-3;     ///< standard deviation, of the diameter
    double power_kw = 0.05;    ///< standard deviation
    double force_share = 0.02; ///< standard deviation relative to the greatest force of the trial
};

struct TrialRequest {
    std::vector<FittedParameter> parameters; ///< parameters of interest
    TrialNoise noise;
};

/// The expected accuracy of one parameter at the current values of the project.
struct TrialExpectation {
    FittedParameter parameter;
    double error = 0; ///< standard error of its coordinate, to first order in the noise: of a
                      ///< factor relative to it
    /// Expected 95 % interval, as the value of a fit has it; of a factor with 1 % more, an estimate
    /// of how well a machine keeps feed and speed.
    double low = 0, high = 0;
};

struct Trial {
    double feedFactor = 1; ///< factor of the feed of the project's first stage
    double radialFeed = 0; ///< feed in the unit of the operation
    TrialSparkOut sparkOut = TrialSparkOut::none;
    TrialRecord record = TrialRecord::size;
    std::vector<int> stepsByStage;
    double duration_s = 0;
    std::size_t samples = 0; ///< number of samples of all traces
    /// ln det of the information about the parameters, with offset and time of the recorder and the
    /// idle power, which a fit proposes, determined from the same traces; not given if some of the
    /// parameters are undetermined.
    std::optional<double> logDeterminant;
    std::vector<TrialExpectation> expected;  ///< empty if some are undetermined
    std::vector<FittedParameter> cannotTell; ///< those without information, alone or together
};

enum class TrialStatus { designed, notApplicable, notRun, stopped };

struct TrialDesign {
    TrialStatus status = TrialStatus::notRun;
    std::vector<Trial> trials; ///< the best first; those with undetermined parameters last
};

/// The cycle of a trial as a project: the feed of the first stage times `feedFactor`, all the
/// stock, then optionally a spark-out; always under gauge control.
[[nodiscard]] Project trialProject(const Project& project, double feedFactor,
                                   TrialSparkOut sparkOut);

/// Trials at a third, one and three times the feed, without and with a spark-out, by four kinds of
/// record: 24. The information of a trial is M = JᵀJ, J the derivatives of the record by the
/// coordinates, divided by its noise, with independent samples; for parameters of interest i and
/// nuisance parameters n it is M_ii − M_in·M_nn⁻¹·M_ni. The best trial has the greatest determinant
/// (D-optimal).
[[nodiscard]] TrialDesign designTrial(const Project& project, const TrialRequest& request,
                                      const std::stop_token& stop = {});

} // namespace sparkout
