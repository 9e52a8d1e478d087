// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/adequacy.h"
#include "core/measured/hold_out.h"
#include "core/measured/identification.h"
#include "core/measured/stiffness_trial.h"
#include "core/measured/trial_design.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sparkout {

/// Reads "compliance:2,alpha,beta=1.2~0.1" as parameters, the last one with a prior: its mean and
/// standard deviation. Empty if one of them is invalid.
[[nodiscard]] std::optional<std::vector<FittedParameter>>
fittedParametersOf(const std::string& text);
[[nodiscard]] std::string parameterName(const FittedParameter& parameter); ///< "compliance:2"
[[nodiscard]] std::string knownParameters();                               ///< "compliance, alpha"
[[nodiscard]] std::string parameterHint(); ///< the notation of places and priors
[[nodiscard]] std::optional<RobustLoss> robustLossOf(const std::string& text); ///< "huber"

/// The comparison of measurements with the prediction, and an optional fit.
struct MeasuredAnswer {
    std::vector<AdequacyRow> rows;
    std::vector<HoldOutRow> holdOut;
    std::optional<Identification> fit;
    std::vector<FittedParameter> parameters; ///< parameters of the fit
};

/// A time omitted from a fit of these parameters.
struct OutOfStepOf {
    const std::vector<FittedParameter>& parameters;
    const OutOfStep& time;
};

[[nodiscard]] std::span<const Output<Identification>> identificationOutputs();
[[nodiscard]] std::span<const Output<FittedValue>> fittedValueOutputs();
[[nodiscard]] std::span<const Output<FitResiduals>> fitResidualsOutputs();
[[nodiscard]] std::span<const Output<OutOfStepOf>> outOfStepOutputs();
[[nodiscard]] std::span<const Output<ForceLawChoice>> forceLawOutputs();
[[nodiscard]] std::span<const Output<HoldOutRow>> holdOutOutputs();

/// The object of `measured --json`.
[[nodiscard]] std::string measuredJson(const Project& project, const MeasuredAnswer& answer);

/// A value of the core as text: its key in JSON, and the English text, which the window translates
/// in the context "Measured".
struct MeasuredWords {
    const char* key;
    const char* text;
};

[[nodiscard]] MeasuredWords wordsOf(IdentificationStatus status);
/// The recommended measurement.
[[nodiscard]] MeasuredWords wordsOf(Advice advice);
[[nodiscard]] MeasuredWords wordsOf(SupportedLaw law);
[[nodiscard]] MeasuredWords wordsOf(HoldOutQuantity quantity);
/// For a project with or without a threshold of the force.
[[nodiscard]] MeasuredWords wordsOf(FittedKind kind, bool hasThreshold = false);
[[nodiscard]] MeasuredWords wordsOf(FitSource source);
/// The cause of a lack of fit.
[[nodiscard]] MeasuredWords wordsOf(Unlike unlike);

/// The advice for lone readings beyond the range of all others.
[[nodiscard]] const char* overRangeAdvice();

/// In English, like the others.
[[nodiscard]] const char* textOf(AdequacyVerdict verdict);

[[nodiscard]] const char* unitOf(HoldOutQuantity quantity);
/// The unit of the residuals of a source.
[[nodiscard]] const char* unitOf(FitSource source);

// Keys, and texts in English; the window translates these in the context "Trial".
[[nodiscard]] MeasuredWords wordsOf(TrialRecord record);
[[nodiscard]] MeasuredWords wordsOf(TrialSparkOut sparkOut);
[[nodiscard]] MeasuredWords wordsOf(TrialStatus status);
[[nodiscard]] MeasuredWords wordsOf(StiffnessUnit unit);
[[nodiscard]] MeasuredWords wordsOf(StiffnessTrialStatus status);
[[nodiscard]] MeasuredWords wordsOf(LoadLine line);

} // namespace sparkout
