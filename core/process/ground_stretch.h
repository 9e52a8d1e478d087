// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// A part of the ground length, from its headstock end.
struct Stretch {
    double from_mm = 0; ///< its end nearer to the headstock [mm]
    double to_mm = 0;   ///< the other one [mm]
};

/// What the zones РЗ1, НЗ, РЗ2 or the sections stand for, in this order, without the relief before
/// the wall of a blind bore. With the entry at the
/// tailstock the zones come from the far end.
[[nodiscard]] std::vector<Stretch> groundStretches(const Project& project);

} // namespace sparkout
