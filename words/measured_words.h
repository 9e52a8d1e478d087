// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/identification/hold_out.h"
#include "core/identification/identification.h"

namespace sparkout {

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

/// The unit of a parameter's value; empty for a factor.
[[nodiscard]] const char* unitOf(FittedKind kind);
[[nodiscard]] const char* unitOf(HoldOutQuantity quantity);
/// The unit of the residuals of a source.
[[nodiscard]] const char* unitOf(FitSource source);

} // namespace sparkout
