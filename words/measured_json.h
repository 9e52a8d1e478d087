// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/identification/identification.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// "compliance:2,alpha" as parameters; nothing where one of them is none.
[[nodiscard]] std::optional<std::vector<FittedParameter>>
fittedParametersOf(const std::string& text);
[[nodiscard]] std::string parameterName(const FittedParameter& parameter); ///< "compliance:2"
[[nodiscard]] std::string knownParameters();                               ///< "compliance, alpha"

[[nodiscard]] const char* keyOf(MeasuredQuantity quantity);
/// A zone or section by its name in JSON, or the part.
[[nodiscard]] std::string placeName(const Project& project, int place);

/// What was measured held against the prediction and, where asked for, fitted to.
struct MeasuredAnswer {
    std::vector<AdequacyRow> rows;
    std::optional<Identification> fit;
    std::vector<FittedParameter> parameters; ///< of the fit
};

/// The object of `measured --json`.
[[nodiscard]] std::string measuredJson(const Project& project, const MeasuredAnswer& answer);

} // namespace sparkout
