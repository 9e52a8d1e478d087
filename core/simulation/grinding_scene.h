// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/profile.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// One zone or section at the wheel, with the radius that faces it.
struct SceneSurface {
    Zone zone = Zone::section;
    int section = 0;      ///< counted from 0
    Stretch stretch;      ///< its part of the ground length
    double radius_mm = 0; ///< R_k after its last cut
    double yield_mm = 0;  ///< deflection under the wheel, y = h − a ≥ 0
};

/// Wheel and part at a moment of the cycle, seen from the side. All deflection is drawn at the
/// part, though wheel head and supports deflect too [MODEL-6], so the surface being cut touches the
/// wheel's edge: R_k − y = R_max0 − t_П, in a bore R_k + y = R_min0 + t_П. In traverse grinding the
/// part deflects as one body, by the balance of the zone under the wheel's middle; in plunge
/// grinding each section deflects by its own balance.
struct GrindingScene {
    Operation operation;
    double removalSign = 1;   ///< +1 external, −1 internal
    Stretch wheel;            ///< length covered by the wheel, with the overruns beyond the ends
    double edge_mm = 0;       ///< radius of the wheel's edge
    int radius = 0;           ///< k that faces the wheel
    std::size_t leading = 0;  ///< the surface under the wheel's middle
    double programmed_mm = 0; ///< t_П
    double cut_mm = 0;        ///< a of the leading surface
    double force_n = 0;       ///< P_y there
    double gauge_mm = 0;      ///< position of the gauge along the ground length
    std::vector<SceneSurface> surfaces;
};

/// Returns the scene at a moment with open passes. At the blank the wheel is at the entry, at first
/// touch. Without a trajectory there are no surfaces.
[[nodiscard]] GrindingScene grindingScene(const SimulationResult& result,
                                          const Trajectory& trajectory, const Progress& moment);

} // namespace sparkout
