// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/wave_causes.h"

/// What can have left counted waves, as texts: English, marked for translation in the context
/// "Waves".
namespace sparkout {

/// "the wheel, with %1 waves around it": the place is for numberOf().
[[nodiscard]] const char* textOf(const WaveCause& cause);
/// The waves around the wheel, or the frequency [Hz].
[[nodiscard]] double numberOf(const WaveCause& cause);
/// How to tell the causes apart.
[[nodiscard]] const char* waveTestText();

} // namespace sparkout
