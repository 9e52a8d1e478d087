// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/stroke_step.h"

#include <algorithm>

namespace sparkout {

StrokeStep strokeStep(Zone zone, Step step) {
    using enum StrokeStep;
    constexpr StrokeStep rz1[] = {none,          plungeIn,     entryDwell,
                                  workingStroke, returnStroke, dwellAfterReturn};
    constexpr StrokeStep nz[] = {none, workingStroke, returnStroke, none, none, none};
    constexpr StrokeStep rz2[] = {none, workingStroke, exitDwell, returnStroke, exitPlungeIn, none};
    const int i = std::clamp(static_cast<int>(step), 0, 5);
    switch (zone) {
    case Zone::rz1: return rz1[i];
    case Zone::nz: return nz[i];
    case Zone::rz2: return rz2[i];
    case Zone::section: break;
    }
    return none;
}

Step stepOf(Zone zone, StrokeStep step) {
    for (const Step of : {Step::e1, Step::e2, Step::e3, Step::e4, Step::e5}) {
        if (step != StrokeStep::none && strokeStep(zone, of) == step) {
            return of;
        }
    }
    return Step::none;
}

} // namespace sparkout
