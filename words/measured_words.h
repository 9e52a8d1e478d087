// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/identification/hold_out.h"
#include "core/identification/identification.h"

namespace sparkout {

/// A value of the core in words: its key in JSON, and the text, in English; the window translates
/// it in the context "Measured".
struct MeasuredWords {
    const char* key;
    const char* text;
};

[[nodiscard]] MeasuredWords wordsOf(IdentificationStatus status);
/// What to measure.
[[nodiscard]] MeasuredWords wordsOf(Advice advice);
[[nodiscard]] MeasuredWords wordsOf(SupportedLaw law);
[[nodiscard]] MeasuredWords wordsOf(HoldOutQuantity quantity);
/// Of a project whose force has a threshold or of another.
[[nodiscard]] MeasuredWords wordsOf(FittedKind kind, bool hasThreshold = false);
[[nodiscard]] MeasuredWords wordsOf(FitSource source);
/// What a trace has that the cycle that was run has not.
[[nodiscard]] MeasuredWords wordsOf(Unlike unlike);

/// In English, as the others.
[[nodiscard]] const char* textOf(AdequacyVerdict verdict);

/// The unit of a parameter's value; empty for a factor.
[[nodiscard]] const char* unitOf(FittedKind kind);
[[nodiscard]] const char* unitOf(HoldOutQuantity quantity);
/// The unit of the residuals of a source.
[[nodiscard]] const char* unitOf(FitSource source);

} // namespace sparkout
