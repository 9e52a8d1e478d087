// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// A part of the ground length, from its headstock end.
struct Stretch {
    double from_mm = 0; ///< end nearer to the headstock [mm]
    double to_mm = 0;   ///< the other one [mm]
};

/// The stretches of the zones РЗ1, НЗ, РЗ2 or of the sections, in this order, without the relief
/// before the wall of a blind bore. With the entry at the tailstock the zones are counted from that
/// end.
[[nodiscard]] std::vector<Stretch> groundStretches(const Project& project);

} // namespace sparkout
