// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <vector>

namespace sparkout {

enum class OptimisationScenarios { nominal, corners, batch };

/// The grid the optimiser searches.
struct Optimisation {
    std::vector<double> stages = {1, 2}; ///< numbers of stages tried
    double stock_step_mm = 0.01;         ///< [mm]
    std::optional<std::vector<double>>
        last_stock_mm; ///< least and most of the last of several [mm]
    bool non_increasing = false;
    OptimisationScenarios scenarios = OptimisationScenarios::nominal;
    Levels radial_feed_mm;     ///< traverse, per double stroke [mm]
    Levels axial_feed_mm_min;  ///< traverse [mm/min]
    Levels radial_feed_mm_min; ///< plunge [mm/min]
};

} // namespace sparkout
