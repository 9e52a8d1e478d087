// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sparkout {

/// What was measured of one quantity in one zone or section [µm].
struct MeasuredStatistics {
    MeasuredQuantity quantity = MeasuredQuantity::diameter_deviation;
    int place = 0; ///< −1: of the whole part
    std::int64_t count = 0;
    double mean = 0;
    std::optional<double> deviation; ///< of two values or more, or as stated
    std::optional<double> least, greatest;
    std::vector<double> values; ///< in rising order; of a summary none
    bool isSummary = false;
};

/// Of all that was measured in the zones or sections the project has, by quantity and place; what
/// is summed up stands behind what is listed. Several diameters of a part count as their mean.
[[nodiscard]] std::vector<MeasuredStatistics> statisticsOfMeasured(const Project& project);

} // namespace sparkout
