// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/project/project.h"
#include "core/result.h"

#include <span>

namespace sparkout {

/// A judged quantity, and its project.
struct AdequacyOf {
    const Project& project;
    const AdequacyRow& row;
};

[[nodiscard]] std::span<const Output<AdequacyOf>> adequacyOutputs();
[[nodiscard]] std::span<const Output<PredictedRange>> predictedOutputs();
[[nodiscard]] std::span<const Output<VarianceRatio>> varianceRatioOutputs();
[[nodiscard]] std::span<const Output<InsideShare>> insideShareOutputs();

/// Names in files and on the command line: "diameter_deviation", "scatter_differs".
[[nodiscard]] const char* keyOf(MeasuredQuantity quantity);
[[nodiscard]] const char* keyOf(AdequacyVerdict verdict);
[[nodiscard]] const char* keyOf(MeanPlace place);
/// A zone or section by its name in JSON, or the part.
[[nodiscard]] std::string placeKey(const Project& project, int place);

} // namespace sparkout
