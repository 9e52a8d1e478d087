// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/wave_words.h"

#include "core/text.h"

namespace sparkout {

const char* textOf(const WaveCause& cause) {
    switch (cause.source) {
    case WaveSource::wheel: break;
    case WaveSource::frequency: return SPARKOUT_NOOP("Waves", "a known frequency, %1 Hz");
    case WaveSource::wheelHead:
        return SPARKOUT_NOOP("Waves", "chatter at the wheel head’s natural frequency, %1 Hz");
    case WaveSource::work:
        return SPARKOUT_NOOP("Waves", "fixed to the work: centres, headstock, blank");
    }
    return cause.lobes == 1 ? SPARKOUT_NOOP("Waves", "the wheel: runout or unbalance")
                            : SPARKOUT_NOOP("Waves", "the wheel, with %1 waves around it");
}

double numberOf(const WaveCause& cause) {
    return cause.source == WaveSource::wheel ? cause.lobes : cause.frequency_hz;
}

const char* waveTestText() {
    return SPARKOUT_NOOP(
        "Waves",
        "Grind with each of the other speeds in turn and count again: the count of the true cause "
        "becomes what is stated here. If the cause is the wheel, force and power ripple off a "
        "whole ratio of the speeds and not at it.");
}

} // namespace sparkout
