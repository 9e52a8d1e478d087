// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/shop_numbers.h"

#include <nlohmann/json.hpp>

#include <string>

namespace sparkout::cli {

/// The value of "shop" in `simulate --json`:
///
///     { "stages": [ {…}, … ], "cycle": {…},
///       "wheel_speed_rpm", "rotation_ratio", "rotation_ratio_near_integer" }
///
/// with, for each stage and for the cycle, removal_rate_mm3_mm_s (Q'_w), equivalent_chip_um (h_eq)
/// and aggressiveness at largest_depth_um; mean_removal_rate_mm3_mm_s; overlap_ratio;
/// specific_energy_j_mm3 and specific_energy_plausible; peak_power_w, mean_power_w,
/// peak_normal_force_n; and what they are made of: removed_volume_mm3, energy_j,
/// grinding_time_min. Peaks have a …_where. What there is none of is null.
[[nodiscard]] nlohmann::ordered_json shopJson(const ShopNumbers& shop);

/// The same for people: a row a quantity, a column a stage and one for the cycle.
[[nodiscard]] std::string shopText(const ShopNumbers& shop);

} // namespace sparkout::cli
