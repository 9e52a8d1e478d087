// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/stiffness_trial.h"
#include "core/identification/trial_design.h"
#include "words/measured_words.h"

namespace sparkout {

// Keys, and texts in English; the window translates these in the context "Trial".
[[nodiscard]] MeasuredWords wordsOf(TrialRecord record);
[[nodiscard]] MeasuredWords wordsOf(TrialSparkOut sparkOut);
[[nodiscard]] MeasuredWords wordsOf(TrialStatus status);
[[nodiscard]] MeasuredWords wordsOf(StiffnessUnit unit);
[[nodiscard]] MeasuredWords wordsOf(StiffnessTrialStatus status);
[[nodiscard]] MeasuredWords wordsOf(LoadLine line);

} // namespace sparkout
