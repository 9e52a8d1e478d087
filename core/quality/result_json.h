// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/result.h"
#include "core/surface/accuracy.h"

#include <span>
#include <string>

namespace sparkout {

/// The form of a zone with several sections.
struct ZoneFormFigures {
    const SectionAccuracy* worst = nullptr; ///< its least round section
    const ZoneForm* form = nullptr;
    bool isKnown = true; ///< false where strips stay uncut
};

[[nodiscard]] std::span<const Output<ZoneFormFigures>> zoneFormOutputs();

/// A result as one JSON object: the output of `sparkout-cli simulate --json` and of the window's
/// export; its named keys are fixed. "shop" holds the shop's numbers:
///
///     { "stages": [ {…}, … ], "cycle": {…},
///       "wheel_speed_rpm", "rotation_ratio", "rotation_ratio_near_integer" }
///
/// with, for each stage and for the cycle, removal_rate_mm3_mm_s (Q'_w), equivalent_chip_um (h_eq)
/// and aggressiveness at largest_depth_um; mean_removal_rate_mm3_mm_s; overlap_ratio;
/// specific_energy_j_mm3 and specific_energy_plausible; peak_power_w, mean_power_w,
/// peak_normal_force_n; and their components: removed_volume_mm3, energy_j, grinding_time_min,
/// which is the machining time. Peaks have a …_where. Missing values are null.
[[nodiscard]] std::string resultJson(const SimulationResult& result,
                                     const std::vector<ConstraintResult>& constraints);

} // namespace sparkout
