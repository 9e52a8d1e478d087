// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/identification/hold_out.h"
#include "core/identification/identification.h"
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

} // namespace sparkout
