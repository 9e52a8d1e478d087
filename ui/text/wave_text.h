// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/wave_causes.h"

#include <QString>

namespace sparkout {

/// The causes of counted waves in the current language.
struct WaveText {
    static QString cause(const WaveCause& cause);
    static QString howToTell(); ///< the causes apart
};

} // namespace sparkout
