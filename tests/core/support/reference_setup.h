// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/support/reference_simulation.h"

#include <nlohmann/json.hpp>

#include <vector>

/// The second implementation of a set-up: its surfaces one after the other, from the text of a file
/// of version 2. It shares no code with core/.
namespace sparkout::reference {

struct SurfaceResult {
    nlohmann::json project; ///< with the wheel as it came to the surface
    Result result;
    double removed_mm3 = 0;
};

struct SetupResult {
    std::vector<SurfaceResult> surfaces;
    bool completed = false; ///< every surface
    // The times of the part in minutes, once it is completed.
    double main_min = 0, auxiliary_min = 0, piece_min = 0, preparation_min = 0, calculation_min = 0;
};

/// Runs every surface of a valid file, in its order.
SetupResult simulateSetup(const nlohmann::json& file);

} // namespace sparkout::reference
